// Balls that run into each other, over a plane.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 1 }
// POV-Ray's axes are left-handed. With the camera's right side turned over, the same numbers give the same picture:
// translations and scales carry over as they are, and so do rotations, whose sense turns over with the axes.
camera {
  location <1, 2.5, 7>
  up y
  right -x * 320 / 240
  angle 59.99999999999999
  look_at <0, 0.5, 0>
}
#default { finish { ambient 1 diffuse 0 } }
#declare Red = texture { pigment { rgb <1, 0, 0> } }
#declare Green = texture { pigment { rgb <0, 1, 0> } }
#declare Blue = texture { pigment { rgb <0, 0, 1> } }
#declare Yellow = texture { pigment { rgb <1, 1, 0> } }
#declare Cyan = texture { pigment { rgb <0, 1, 1> } }
#declare Magenta = texture { pigment { rgb <1, 0, 1> } }
#declare Black = texture { pigment { rgb <0, 0, 0> } }

#declare A_ = sphere { 0, 1 texture { Red } }
#declare B_ = sphere { 0, 1 scale <0.8, 0.8, 0.8> translate <0.9, 0.6, 0.3> texture { Green } }
#declare C_ = sphere { 0, 1 scale <1.2, 1.2, 1.2> translate <-1.6, 0.4, -0.5> texture { Blue } }
#declare D_ = sphere { 0, 1 scale <0.5, 0.5, 0.5> translate <-0.3, 0.9, 1> texture { Yellow } }
#declare E_ = sphere { 0, 1 scale <0.7, 0.7, 0.7> translate <2.6, -0.4, 1.4> texture { Magenta } }
#declare F_ = plane { y, 0 translate <0, -0.6, 0> texture { Cyan } }
#declare U0_ = union { object { A_ } object { B_ } }
#declare U1_ = union { object { U0_ } object { C_ } }
#declare U2_ = union { object { U1_ } object { D_ } }
#declare U3_ = union { object { U2_ } object { E_ } }
#declare U4_ = union { object { U3_ } object { F_ } }
object { U4_ }
