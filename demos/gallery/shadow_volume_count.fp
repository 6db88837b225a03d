!!ARBfp1.0
#@ keep, color off, depth less write off, stencil count
#@ mesh volume of torus parts 32 at 0 0.3 0 scale 0.8, vertex shadow_volume_count.vp
PARAM none = { 0.0, 0.0, 0.0, 0.0 };
MOV result.color, none;
END
