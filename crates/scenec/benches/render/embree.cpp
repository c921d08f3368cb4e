// What a good library does with the same rays: balls over a ground at y = 0, Phong's model with shadows and mirrors,
// through Embree 3's sphere points, one ray at a time, two threads. Reads the numbers that words.rs writes, prints
// "build_ms trace_ms rays", and writes a picture (PPM) if a second path is given.
#include <embree3/rtcore.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <thread>
#include <vector>

struct V {
    float x, y, z;
};
static V operator+(V a, V b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
static V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
static V operator*(V a, float s) { return {a.x * s, a.y * s, a.z * s}; }
static V operator*(V a, V b) { return {a.x * b.x, a.y * b.y, a.z * b.z}; }
static float dot(V a, V b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
static V unit(V a) { return a * (1 / std::sqrt(dot(a, a))); }
static V cross(V a, V b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

struct Light {
    V position, colour;
};
struct Material {
    float ambient, diffuse, specular, reflect, refract, index, shiny;
    V colour;
};

static std::vector<Light> lights;
static std::vector<Material> materials;
static std::vector<int> made_of;
static V ambient;
static RTCScene scene;
static float reach[64];

static float ground(V o, V d) {
    float t = -o.y / d.y;
    return t > 1e-4f ? t : INFINITY;
}

static bool blocked(V p, V d, float until) {
    if (ground(p, d) < until) return true;
    RTCRay ray{};
    ray.org_x = p.x, ray.org_y = p.y, ray.org_z = p.z, ray.tnear = 1e-4f;
    ray.dir_x = d.x, ray.dir_y = d.y, ray.dir_z = d.z, ray.tfar = until, ray.mask = ~0u;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcOccluded1(scene, &context, &ray);
    return ray.tfar < 0;
}

static V trace(V o, V d, int depth, uint64_t& rays) {
    V sum{0, 0, 0};
    float weight = 1;
    for (;; depth--) {
        rays++;
        float floor = ground(o, d);
        RTCRayHit hit{};
        hit.ray.org_x = o.x, hit.ray.org_y = o.y, hit.ray.org_z = o.z, hit.ray.tnear = 1e-4f;
        hit.ray.dir_x = d.x, hit.ray.dir_y = d.y, hit.ray.dir_z = d.z, hit.ray.tfar = floor, hit.ray.mask = ~0u;
        hit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect1(scene, &context, &hit);
        V n{0, 1, 0};
        int which = 0;
        if (hit.hit.geomID != RTC_INVALID_GEOMETRY_ID) {
            n = unit({hit.hit.Ng_x, hit.hit.Ng_y, hit.hit.Ng_z});
            which = made_of[hit.hit.primID];
        } else if (std::isinf(floor)) {
            float high = (d.y + 1) / 2;
            return sum + (V{1, 1, 1} * (1 - high) + ambient * high) * weight;
        }
        const Material& m = materials[which];
        V p = o + d * hit.ray.tfar;
        V own = m.colour * ambient * m.ambient;
        for (const Light& light : lights) {
            V way = light.position - p;
            float length = std::sqrt(dot(way, way));
            V l = way * (1 / length);
            float cosine = dot(n, l);
            if (cosine <= 0) continue;
            rays++;
            if (blocked(p, l, length)) continue;
            float shine = 0;
            if (m.specular != 0) {
                V gap = n * (2 * cosine) - l + d;
                float small = dot(gap, gap) / 2;
                if (small < 1) shine = m.specular * std::exp(m.shiny * std::log1p(-small));
            }
            own = own + (m.colour * (m.diffuse * cosine) + V{shine, shine, shine}) * light.colour;
        }
        sum = sum + own * weight;
        weight *= m.reflect;
        if (depth == 0 || weight == 0 || weight * reach[depth - 1] < 1.f / 4096) return sum;
        d = unit(d - n * (2 * dot(d, n)));
        o = p;
    }
}

static double now() {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

int main(int argc, char** argv) {
    FILE* in = argc > 1 ? fopen(argv[1], "r") : nullptr;
    if (!in) return 1;
    int width, height, depth, count;
    V eye, look_at;
    bool ok = fscanf(in, "%d%d%d", &width, &height, &depth) == 3;
    for (V* v : {&eye, &look_at, &ambient}) ok = ok && fscanf(in, "%f%f%f", &v->x, &v->y, &v->z) == 3;
    ok = ok && fscanf(in, "%d", &count) == 1;
    lights.resize(ok ? count : 0);
    for (Light& l : lights)
        for (V* v : {&l.position, &l.colour}) ok = ok && fscanf(in, "%f%f%f", &v->x, &v->y, &v->z) == 3;
    ok = ok && fscanf(in, "%d", &count) == 1;
    materials.resize(ok ? count : 0);
    for (Material& m : materials)
        for (int i = 0; i < 10; i++) ok = ok && fscanf(in, "%f", (float*)&m + i) == 1;
    ok = ok && fscanf(in, "%d", &count) == 1;
    if (!ok) return 1;
    std::vector<float> balls(4 * size_t(count));
    made_of.resize(count);
    for (int i = 0; i < count; i++) {
        float* b = &balls[4 * size_t(i)];
        if (fscanf(in, "%f%f%f%f%d", b, b + 1, b + 2, b + 3, &made_of[i]) != 5) return 1;
    }
    fclose(in);
    // As the tracer beside it bounds what a ray can bring back.
    for (int j = 0; j < 64; j++) reach[j] = j == 0 ? 1.5f : 1.5f + 0.4f * reach[j - 1];

    double start = now();
    RTCDevice device = rtcNewDevice("threads=2");
    scene = rtcNewScene(device);
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_SPHERE_POINT);
    void* buffer = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4, 16, count);
    std::copy(balls.begin(), balls.end(), (float*)buffer);
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcCommitScene(scene);
    double built = now();

    V f = unit(look_at - eye), r = unit(cross(f, {0, 1, 0})), u = cross(r, f) * (float(height) / width);
    std::vector<V> picture(size_t(width) * height);
    std::atomic<int> next{0};
    std::atomic<uint64_t> all{0};
    const int side = 16, columns = (width + side - 1) / side, tiles = columns * ((height + side - 1) / side);
    auto work = [&] {
        uint64_t rays = 0;
        for (int tile; (tile = next++) < tiles;) {
            int x0 = tile % columns * side, y0 = tile / columns * side;
            for (int y = y0; y < std::min(y0 + side, height); y++)
                for (int x = x0; x < std::min(x0 + side, width); x++) {
                    V d = unit(f + r * ((2 * x + 1.f - width) / width) + u * -((2 * y + 1.f - height) / height));
                    picture[size_t(y) * width + x] = trace(eye, d, depth, rays);
                }
        }
        all += rays;
    };
    std::thread other(work);
    work();
    other.join();
    printf("%.3f %.3f %llu\n", built - start, now() - built, (unsigned long long)all);

    if (FILE* out = argc > 2 ? fopen(argv[2], "wb") : nullptr) {
        fprintf(out, "P6 %d %d 255\n", width, height);
        for (V v : picture)
            for (float c : {v.x, v.y, v.z}) fputc(int(std::min(1.f, std::max(0.f, c)) * 255 + 0.5f), out);
        fclose(out);
    }
}
