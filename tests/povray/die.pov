// A box of six half-spaces, its corners taken off by a ball, less the balls of its pips.
#version 3.7;
global_settings { assumed_gamma 1 }
background { rgb 1 }
// POV-Ray's axes are left-handed. With the camera's right side turned over, the same numbers give the same picture:
// translations and scales carry over as they are, and so do rotations, whose sense turns over with the axes.
camera {
  location <2.4, 2.8, 4.2>
  up y
  right -x * 320 / 240
  angle 40.10704565915762
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

#declare Top_ = plane { y, 0 translate <0, 1, 0> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Red } }
#declare Bottom_ = plane { y, 0 scale <1, -1, 1> translate <0, -1, 0> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Red } }
#declare Right_ = plane { y, 0 rotate z * -90.0 translate <1, 0, 0> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Green } }
#declare Left_ = plane { y, 0 rotate z * 90.0 translate <-1, 0, 0> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Green } }
#declare Front_ = plane { y, 0 rotate x * 90.0 translate <0, 0, 1> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Yellow } }
#declare Back_ = plane { y, 0 rotate x * -90.0 translate <0, 0, -1> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Yellow } }
#declare Corners_ = sphere { 0, 1 scale <1.45, 1.45, 1.45> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Magenta } }
#declare Six0_ = sphere { 0, 1 scale <0.22, 0.22, 0.22> translate <-0.5, 1.05, -0.5> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Black } }
#declare Six1_ = sphere { 0, 1 scale <0.22, 0.22, 0.22> translate <-0.5, 1.05, 0> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Black } }
#declare Six2_ = sphere { 0, 1 scale <0.22, 0.22, 0.22> translate <-0.5, 1.05, 0.5> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Black } }
#declare Six3_ = sphere { 0, 1 scale <0.22, 0.22, 0.22> translate <0.5, 1.05, -0.5> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Black } }
#declare Six4_ = sphere { 0, 1 scale <0.22, 0.22, 0.22> translate <0.5, 1.05, 0> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Black } }
#declare Six5_ = sphere { 0, 1 scale <0.22, 0.22, 0.22> translate <0.5, 1.05, 0.5> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Black } }
#declare Two0_ = sphere { 0, 1 scale <0.25, 0.25, 0.25> translate <-0.4, -0.4, 1.05> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Blue } }
#declare Two1_ = sphere { 0, 1 scale <0.25, 0.25, 0.25> translate <0.4, 0.4, 1.05> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Blue } }
#declare One_ = sphere { 0, 1 scale <0.3, 0.3, 0.3> translate <1.05, 0, 0> rotate y * 20.05352282957881 rotate x * 11.459155902616466 texture { Cyan } }
#declare Box0_ = intersection { object { Top_ } object { Bottom_ } }
#declare Box1_ = intersection { object { Box0_ } object { Right_ } }
#declare Box2_ = intersection { object { Box1_ } object { Left_ } }
#declare Box3_ = intersection { object { Box2_ } object { Front_ } }
#declare Box4_ = intersection { object { Box3_ } object { Back_ } }
#declare Box5_ = intersection { object { Box4_ } object { Corners_ } }
#declare Pips0_ = union { object { Six0_ } object { Six1_ } }
#declare Pips1_ = union { object { Pips0_ } object { Six2_ } }
#declare Pips2_ = union { object { Pips1_ } object { Six3_ } }
#declare Pips3_ = union { object { Pips2_ } object { Six4_ } }
#declare Pips4_ = union { object { Pips3_ } object { Six5_ } }
#declare Pips5_ = union { object { Pips4_ } object { Two0_ } }
#declare Pips6_ = union { object { Pips5_ } object { Two1_ } }
#declare Pips7_ = union { object { Pips6_ } object { One_ } }
#declare Die_ = difference { object { Box5_ } object { Pips7_ } }
object { Die_ }
