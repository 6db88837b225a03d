!!ARBfp1.0
#@ title "Shadow map", size 512 512
#@ target shadow 512 512, clear 1 1 1 1
#@ mesh torus at 0 0.3 0 scale 0.8 and plane at 0 -0.6 0 scale 2 and sphere parts 32 at 0 0.3 0 scale 0.3
#@ camera orbit yaw 40 pitch 50 distance 6 fov 40 near 2 far 12, vertex shadow_map.vp
#@ then shadow_map_scene.fp
# Seen from the light, only depths matter: the second pass asks for them.
PARAM white = { 1.0, 1.0, 1.0, 1.0 };
MOV result.color, white;
END
