// Lenses: the common part of two balls, a ball less a ball, and a half ball.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 1 }
// POV-Ray's axes are left-handed. With the camera's right side turned over, the same numbers give the same picture:
// translations and scales carry over as they are, and so do rotations, whose sense turns over with the axes.
camera {
  location <1, 1.5, 6>
  up y
  right -x * 320 / 240
  angle 57.29577951308232
  look_at <0.2, 0, 0>
}
#default { finish { ambient 1 diffuse 0 } }
#declare Red = texture { pigment { rgb <1, 0, 0> } }
#declare Green = texture { pigment { rgb <0, 1, 0> } }
#declare Blue = texture { pigment { rgb <0, 0, 1> } }
#declare Yellow = texture { pigment { rgb <1, 1, 0> } }
#declare Cyan = texture { pigment { rgb <0, 1, 1> } }
#declare Magenta = texture { pigment { rgb <1, 0, 1> } }
#declare Black = texture { pigment { rgb <0, 0, 0> } }

#declare A_ = sphere { 0, 1 scale <2, 2, 2> translate <0, 0, 1.7> rotate y * 34.37746770784939 translate <-1.7, 0.3, 0> texture { Red } }
#declare B_ = sphere { 0, 1 scale <2, 2, 2> translate <0, 0, -1.7> rotate y * 34.37746770784939 translate <-1.7, 0.3, 0> texture { Blue } }
#declare C_ = sphere { 0, 1 translate <0.9, 0.3, 0> texture { Green } }
#declare D_ = sphere { 0, 1 scale <1.3, 1.3, 1.3> translate <0.9, 0.3, 1.5> rotate y * 5.729577951308233 texture { Yellow } }
#declare E_ = sphere { 0, 1 scale <0.9, 0.9, 0.9> translate <2.1, -1, 1> texture { Magenta } }
#declare F_ = plane { y, 0 rotate x * 34.37746770784939 rotate z * -17.188733853924695 translate <2.1, -1, 1> texture { Cyan } }
#declare P_ = intersection { object { A_ } object { B_ } }
#declare Q_ = difference { object { C_ } object { D_ } }
#declare R_ = intersection { object { E_ } object { F_ } }
#declare S_ = union { object { P_ } object { Q_ } }
#declare T_ = union { object { S_ } object { R_ } }
object { T_ }
