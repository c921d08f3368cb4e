// The seed scene: right-handed there, left-handed here, so z changes its sign. The resolution comes from the command line.
#version 3.7;
global_settings { assumed_gamma 1 max_trace_level 5 ambient_light rgb <0.2, 0.2, 1> }
camera { location <4, 1, -0.5> angle 90 right x*3/2 look_at 0 }
background { rgb <0.6, 0.6, 1> }
light_source { <0, 4, 0> rgb 1 }
light_source { <1, 0, -3> rgb <1, 0, 0> }
sphere {
  <0, 1.75, 0>, 1
  pigment { rgb <0.1, 0.5, 0.1> }
  finish { ambient 0 diffuse 0.5 phong 0.3 phong_size 4 reflection 0.3 }
}
plane {
  y, 0
  pigment { rgb <1, 1, 0> }
  finish { ambient 0.6 diffuse 0.2 phong 0.1 phong_size 1.2 reflection 0.3 }
}
