// A tall picture, from above.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 1 }
// POV-Ray's axes are left-handed. With the camera's right side turned over, the same numbers give the same picture:
// translations and scales carry over as they are, and so do rotations, whose sense turns over with the axes.
camera {
  location <0.5, 7, 1>
  up y
  right -x * 120 / 320
  angle 28.64788975654116
  sky <1, 0, 0>
  look_at <0, 0, 0>
}
#default { finish { ambient 1 diffuse 0 } }
#declare Red = texture { pigment { rgb <1, 0, 0> } }
#declare Green = texture { pigment { rgb <0, 1, 0> } }
#declare Blue = texture { pigment { rgb <0, 0, 1> } }
#declare Yellow = texture { pigment { rgb <1, 1, 0> } }
#declare Cyan = texture { pigment { rgb <0, 1, 1> } }
#declare Magenta = texture { pigment { rgb <1, 0, 1> } }
#declare Black = texture { pigment { rgb <0, 0, 0> } }

#declare A_ = sphere { 0, 1 translate <-1.5, 0.2, 0> texture { Red } }
#declare B_ = sphere { 0, 1 scale <0.5, 0.5, 0.5> translate <1.1, 0.6, 0.4> texture { Green } }
#declare C_ = sphere { 0, 1 scale <2, 0.3, 0.5> rotate y * 34.37746770784939 translate <0.3, 0.4, -0.3> texture { Blue } }
#declare D_ = plane { y, 0 translate <0, -0.3, 0> texture { Yellow } }
#declare E_ = plane { y, 0 rotate x * 68.75493541569878 translate <0, 0, -1.5> texture { Magenta } }
#declare P_ = union { object { A_ } object { B_ } }
#declare Q_ = union { object { P_ } object { C_ } }
#declare R_ = difference { object { D_ } object { E_ } }
#declare S_ = union { object { Q_ } object { R_ } }
object { S_ }
