// Negative scales: a half-space turned over, and ellipsoids mirrored after they were turned and moved.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 1 }
// POV-Ray's axes are left-handed. With the camera's right side turned over, the same numbers give the same picture:
// translations and scales carry over as they are, and so do rotations, whose sense turns over with the axes.
camera {
  location <-2, 2, 7>
  up y
  right -x * 320 / 240
  angle 57.29577951308232
  look_at <0, 0.4, 0>
}
#default { finish { ambient 1 diffuse 0 } }
#declare Red = texture { pigment { rgb <1, 0, 0> } }
#declare Green = texture { pigment { rgb <0, 1, 0> } }
#declare Blue = texture { pigment { rgb <0, 0, 1> } }
#declare Yellow = texture { pigment { rgb <1, 1, 0> } }
#declare Cyan = texture { pigment { rgb <0, 1, 1> } }
#declare Magenta = texture { pigment { rgb <1, 0, 1> } }
#declare Black = texture { pigment { rgb <0, 0, 0> } }

#declare A_ = sphere { 0, 1 scale <1.2, 0.4, 0.6> rotate z * 40.10704565915762 translate <1.5, 0.6, 0.2> scale <-1, 1, 1> texture { Red } }
#declare B_ = sphere { 0, 1 scale <1.2, 0.4, 0.6> rotate z * 40.10704565915762 translate <1.5, 0.6, 0.2> texture { Green } }
#declare C_ = sphere { 0, 1 scale <0.8, -0.5, -1.3> rotate y * 28.64788975654116 translate <0, 1.5, -1> scale <1, 0.7, -1> texture { Blue } }
#declare D_ = plane { y, 0 scale <1, -1, 1> rotate x * 8.594366926962348 translate <0, 4, 0> texture { Yellow } }
#declare E_ = plane { y, 0 rotate z * 11.459155902616466 scale <-1, 1, 1> translate <0, -0.7, 0> texture { Cyan } }
#declare U0_ = union { object { A_ } object { B_ } }
#declare U1_ = union { object { U0_ } object { C_ } }
#declare U2_ = union { object { U1_ } object { D_ } }
#declare U3_ = union { object { U2_ } object { E_ } }
object { U3_ }
