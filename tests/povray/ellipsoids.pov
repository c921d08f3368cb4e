// Ellipsoids: scaled, turned about every axis in several orders, moved, and turned again.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 1 }
// POV-Ray's axes are left-handed. With the camera's right side turned over, the same numbers give the same picture:
// translations and scales carry over as they are, and so do rotations, whose sense turns over with the axes.
camera {
  location <2, 3, 8>
  up y
  right -x * 320 / 240
  angle 51.56620156177409
  look_at <0, 0.2, 0>
}
#default { finish { ambient 1 diffuse 0 } }
#declare Red = texture { pigment { rgb <1, 0, 0> } }
#declare Green = texture { pigment { rgb <0, 1, 0> } }
#declare Blue = texture { pigment { rgb <0, 0, 1> } }
#declare Yellow = texture { pigment { rgb <1, 1, 0> } }
#declare Cyan = texture { pigment { rgb <0, 1, 1> } }
#declare Magenta = texture { pigment { rgb <1, 0, 1> } }
#declare Black = texture { pigment { rgb <0, 0, 0> } }

#declare A_ = sphere { 0, 1 scale <2, 0.5, 0.8> rotate x * 22.918311805232932 rotate y * 51.56620156177409 rotate z * -28.64788975654116 translate <-1.6, 0.8, 0> texture { Red } }
#declare B_ = sphere { 0, 1 scale <0.4, 1.7, 0.6> rotate z * 45.836623610465864 rotate x * -34.37746770784939 translate <1.8, 0.4, 0.2> texture { Green } }
#declare C_ = sphere { 0, 1 translate <1, 0, 0> scale <1.5, 0.7, 0.7> rotate y * -63.02535746439056 translate <0, -1.4, 0.5> texture { Blue } }
#declare D_ = sphere { 0, 1 scale <0.3, 0.9, 0.3> translate <0, 1.1, 0> rotate z * -40.10704565915762 rotate y * 126.05071492878112 translate <0.3, 0.3, 1.2> texture { Yellow } }
#declare E_ = sphere { 0, 1 rotate x * 57.29577951308232 scale <0.5, 0.5, 1.4> rotate y * 17.188733853924695 scale <1, 1.6, 1> translate <3, 2, -2> texture { Magenta } }
#declare U0_ = union { object { A_ } object { B_ } }
#declare U1_ = union { object { U0_ } object { C_ } }
#declare U2_ = union { object { U1_ } object { D_ } }
#declare U3_ = union { object { U2_ } object { E_ } }
object { U3_ }
