!!ARBfp1.0
#@ title "Shadow volume in the stencil buffer", size 512 512, clear 0.4 0.45 0.5 1
#@ mesh torus parts 32 at 0 0.3 0 scale 0.8 and plane at 0 -0.6 0 scale 2
#@ camera orbit yaw -30 pitch 35 distance 5 fov 40, vertex surface.vp
#@ then shadow_volume_count.fp, then shadow_volume_lit.fp
# First all of it as if it lay in shadow, for the depths. The second pass counts how many shadows a
# place is in, the third one adds light where there is none.
PARAM ambient = { 0.2, 0.2, 0.25, 1.0 };
MOV result.color, ambient;
END
