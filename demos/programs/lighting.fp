!!ARBfp1.0
# A point light over a surface whose normals come from a texture.
PARAM lightPosition = program.local[0];    # in texture coordinates; z is its height
PARAM lightColour = program.local[1];      # times its brightness; w: fall-off
PARAM ambient = program.local[2];          # w: shininess
PARAM unpack = {2.0, -1.0, 1.0, 0.0};
ATTRIB place = fragment.texcoord[0];
TEMP normal, surface, toLight, halfway, dots, colour;

TEX normal, place, texture[0], 2D;
TEX surface, place, texture[1], 2D;        # w: gloss

MAD normal.xyz, normal, unpack.x, unpack.y;
DP3 normal.w, normal, normal;
RSQ normal.w, normal.w;
MUL normal.xyz, normal, normal.w;

SUB toLight.xyz, lightPosition, place;
DP3 toLight.w, toLight, toLight;
MAD dots.z, toLight.w, lightColour.w, unpack.z;
RCP dots.z, dots.z;                        # 1 / (1 + fall-off * distance^2)
RSQ toLight.w, toLight.w;
MUL toLight.xyz, toLight, toLight.w;

# The viewer is straight above: halfway is between the light and z.
ADD halfway.xyz, toLight, unpack.wwzw;
DP3 halfway.w, halfway, halfway;
RSQ halfway.w, halfway.w;
MUL halfway.xyz, halfway, halfway.w;

DP3 colour.x, normal, toLight;
DP3 colour.y, normal, halfway;
MOV colour.w, ambient.w;
LIT colour, colour;                        # y: diffuse, z: specular
MUL dots.xy, colour.yzzz, dots.z;
MUL dots.y, dots.y, surface.w;
MAD colour.xyz, lightColour, dots.x, ambient;
MUL colour.xyz, colour, surface;
MAD result.color.xyz, lightColour, dots.y, colour;
MOV result.color.w, unpack.z;
END
