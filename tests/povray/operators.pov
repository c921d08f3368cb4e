// Union, intersection and difference, of balls and of half-spaces.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 1 }
// POV-Ray's axes are left-handed. With the camera's right side turned over, the same numbers give the same picture:
// translations and scales carry over as they are, and so do rotations, whose sense turns over with the axes.
camera {
  location <3, 4, 7>
  up y
  right -x * 320 / 240
  angle 54.4309905374282
  look_at <0, 0.3, 0>
}
#default { finish { ambient 1 diffuse 0 } }
#declare Red = texture { pigment { rgb <1, 0, 0> } }
#declare Green = texture { pigment { rgb <0, 1, 0> } }
#declare Blue = texture { pigment { rgb <0, 0, 1> } }
#declare Yellow = texture { pigment { rgb <1, 1, 0> } }
#declare Cyan = texture { pigment { rgb <0, 1, 1> } }
#declare Magenta = texture { pigment { rgb <1, 0, 1> } }
#declare Black = texture { pigment { rgb <0, 0, 0> } }

#declare A_ = sphere { 0, 1 scale <1.5, 1.5, 1.5> translate <-1.2, 0.4, 0> texture { Red } }
#declare B_ = sphere { 0, 1 translate <-0.5, 1.2, 0.9> texture { Blue } }
#declare K_ = plane { y, 0 rotate z * 51.56620156177409 translate <-1, 1, 0> texture { Yellow } }
#declare C_ = sphere { 0, 1 scale <1.3, 1.3, 1.3> translate <1.7, 0.4, 0> texture { Green } }
#declare D_ = sphere { 0, 1 scale <1.3, 1.3, 1.3> translate <2.6, 0.7, 0.4> texture { Magenta } }
#declare G_ = plane { y, 0 translate <0, -0.8, 0> texture { Cyan } }
#declare H_ = sphere { 0, 1 scale <1.4, 1.4, 1.4> translate <0.6, -0.8, 2> texture { Black } }
#declare P_ = difference { object { A_ } object { B_ } }
#declare Q_ = intersection { object { P_ } object { K_ } }
#declare R_ = intersection { object { C_ } object { D_ } }
#declare S_ = difference { object { G_ } object { H_ } }
#declare V_ = union { object { Q_ } object { R_ } }
#declare W_ = union { object { V_ } object { S_ } }
object { W_ }
