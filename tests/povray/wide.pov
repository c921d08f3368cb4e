// A wide picture: the field of view is that of its width. The camera leans.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 1 }
// POV-Ray's axes are left-handed. With the camera's right side turned over, the same numbers give the same picture:
// translations and scales carry over as they are, and so do rotations, whose sense turns over with the axes.
camera {
  location <0, 1, 5>
  up y
  right -x * 400 / 150
  angle 108.8619810748564
  sky <0.3, 1, 0.1>
  look_at <0.5, 0.2, 0>
}
#default { finish { ambient 1 diffuse 0 } }
#declare Red = texture { pigment { rgb <1, 0, 0> } }
#declare Green = texture { pigment { rgb <0, 1, 0> } }
#declare Blue = texture { pigment { rgb <0, 0, 1> } }
#declare Yellow = texture { pigment { rgb <1, 1, 0> } }
#declare Cyan = texture { pigment { rgb <0, 1, 1> } }
#declare Magenta = texture { pigment { rgb <1, 0, 1> } }
#declare Black = texture { pigment { rgb <0, 0, 0> } }

#declare A_ = sphere { 0, 1 translate <-4, 0.5, 0> texture { Red } }
#declare B_ = sphere { 0, 1 scale <1, 2, 1> translate <4.2, 0.6, -0.5> texture { Green } }
#declare C_ = sphere { 0, 1 texture { Blue } }
#declare D_ = plane { y, 0 rotate x * 5.729577951308233 translate <0, -1, 0> texture { Cyan } }
#declare E_ = sphere { 0, 1 scale <0.4, 0.4, 0.4> translate <7, 3, 1> texture { Magenta } }
#declare U0_ = union { object { A_ } object { B_ } }
#declare U1_ = union { object { U0_ } object { C_ } }
#declare U2_ = union { object { U1_ } object { D_ } }
#declare U3_ = union { object { U2_ } object { E_ } }
object { U3_ }
