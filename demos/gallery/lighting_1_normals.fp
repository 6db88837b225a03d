!!ARBfp1.0
#@ title "Lighting 1: normals as colours", size 512 512
#@ mesh torus, camera orbit pitch 35 distance 2.8, vertex tangent.vp
#@ texcoord 1 = tangent, texcoord 2 = binormal
#@ texture 0 = normals strength 3 of bumps 256 256 count 8, linear
# The first stage shows what the others read: a vector is a colour.
TEX result.color, fragment.texcoord[0], texture[0], 2D;
END
