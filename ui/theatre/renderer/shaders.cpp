// SPDX-License-Identifier: GPL-3.0-or-later
// All lighting happens in camera space: the light is next to the lens, so most of it is a function of the
// fragment's own place. Cost counts: everything here also runs on a processor.
#include "ui/theatre/renderer/shaders.h"

namespace fulcrum::ui::shaders {

const char* const head = "#version 330 core\n";

const char* const light_each_fragment = "#define LIGHT_EACH_FRAGMENT\n";
const char* const shade_each_fragment = "#define SHADE_EACH_FRAGMENT\n";
const char* const with_ink = "#define INK\n";
const char* const within = "#define WITHIN\n";
const char* const with_layers = "#define LAYERS\n";
const char* const with_fibres = "#define FIBRES\n";

const char* const light = R"(
uniform vec3 lamp;            // camera space
uniform float brightness;
uniform vec4 shadow_from[2];  // camera space, one a tool; w: strength of the shadow, 0 none
uniform vec4 shadow_to[2];    // w: radius
uniform vec2 strain;          // per tool

// Squared distance from p to the segment ab.
float segment_distance(vec3 p, vec3 a, vec3 b) {
    vec3 ab = b - a, ap = p - a;
    vec3 off = ap - clamp(dot(ap, ab) / dot(ab, ab), 0.0, 1.0) * ab;
    return dot(off, off);
}

// One tool's share; ray: from the shadows' lamp to p, which is `far` away.
vec2 shade_of(vec4 heel, vec4 end, float strained, vec3 p, vec3 from, vec3 ray, float far) {
    float r2 = end.w * end.w;
    // Contact: what lies close to the jaws is closed in by them.
    float d2 = segment_distance(p, heel.xyz, end.xyz);
    float near_tip = exp2(-1.2 * d2 / r2);
    // Shadow: the jaws thrown onto the tissue along the rays of a lamp that sits a little higher than it does.
    vec3 tip = end.xyz - from;
    float along = dot(tip, ray);
    vec3 off = tip - along * ray;
    float gap = max(far - along, 0.0);
    float width = 0.8 * end.w + 0.12 * gap;
    float thrown = exp2(-1.4 * dot(off, off) / (width * width) - gap * 22.0);
    return vec2(1.0 - heel.w * (0.78 * near_tip + 0.60 * thrown * (1.0 - near_tip)),
                strained * exp2(d2 * (-1.0 / (0.006 * 0.006))));
}

// What instruments take away: x the share of light that arrives, y how much tissue is squeezed pale.
vec2 shade(vec3 p) {
    vec3 from = lamp + vec3(0.0, 0.016, 0.0);
    vec3 way = p - from;
    float far = length(way);
    vec3 ray = way / far;
    vec2 one = shade_of(shadow_from[0], shadow_to[0], strain.x, p, from, ray, far);
    vec2 two = shade_of(shadow_from[1], shadow_to[1], strain.y, p, from, ray, far);
    return vec2(one.x * two.x, min(one.y + two.y, 1.0));
}

// Light that arrives at p: bright centre, fall-off with distance.
float arriving(vec3 p) {
    vec3 to_lamp = lamp - p;
    float d2 = dot(to_lamp, to_lamp);
    float fall = 0.95 / (0.40 + d2 * 70.0 + d2 * d2 * 1500.0);
    float axis = -p.z * inversesqrt(dot(p, p));
    float beam = smoothstep(0.70, 1.0, axis);
    return brightness * fall * (0.42 + 0.75 * beam);
}
)";

const char* const surface_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 coordinates;
layout(location = 3) in float detail;
uniform mat4 to_camera;
uniform mat4 projection;
out vec3 place;      // camera space
out vec3 facing;     // camera space
out vec2 uv;
out vec3 arrived;    // light, squeezed pale, and what the vertex knows: fraction along the mesentery
#ifdef WITHIN
uniform float thickness;  // m, of the wall
#endif
void main() {
#ifdef WITHIN
    vec4 p = to_camera * vec4(position - thickness * normal, 1.0);
    float known = 1.0;
#else
    vec4 p = to_camera * vec4(position, 1.0);
    float known = detail;
#endif
    place = p.xyz;
    facing = mat3(to_camera) * normal;
    uv = coordinates;
    // Shadow changes slowly over a few millimetres, and light where triangles are small: once a vertex is enough.
    vec2 shaded = shade(p.xyz);
#ifdef LIGHT_EACH_FRAGMENT
    arrived = vec3(shaded, known);

#else
    arrived = vec3(arriving(p.xyz) * shaded.x, shaded.y, known);
#endif
    gl_Position = projection * p;
}
)";

const char* const rigid_vertex = R"(
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec2 coordinates;
uniform mat4 to_camera;   // with the part's own pose
uniform mat4 projection;
out vec3 place;
out vec3 facing;
out vec2 uv;
out vec3 own;             // in the part's own frame
void main() {
    vec4 p = to_camera * vec4(position, 1.0);
    place = p.xyz;
    facing = mat3(to_camera) * normal;
    uv = coordinates;
    own = position;
    gl_Position = projection * p;
}
)";

const char* const wet = R"(
// Linear light to the screen: a soft shoulder, then gamma 2.
vec3 expose(vec3 c) {
    c = c * (1.0 + c * 0.03) / (0.75 + c);
    return sqrt(min(c, 1.0));
}

// A wet surface under the lamp, which is so close to the lens that the direction to one does for both. The film
// reflects twice: a broad sheen and a sharp glint.
vec3 wet(vec3 colour, vec3 n, vec3 film, vec3 to_eye, float wetness, float light) {
    float raw = dot(n, to_eye);
    // Nothing wet is black at its rim: the neighbourhood lights it a little.
    float diffuse = max(raw * 0.88 + 0.12, 0.0);
    float across = max(dot(film, to_eye), 0.0);
    float a2 = across * across;
    float a4 = a2 * a2;
    float a8 = a4 * a4;
    float a16 = a8 * a8;
    float sheen = a16 * a16;
    float s128 = sheen * sheen;
    s128 *= s128;
    float glint = s128 * s128 * s128;
    float rim = 1.0 - max(raw, 0.0);
    float fresnel = 0.30 + 0.70 * rim * rim;
    // Blood beneath carries red light sideways into the half-shade.
    vec3 body = colour * vec3(diffuse * 0.72 + 0.28 * max(raw * 0.8 + 0.2, 0.0), diffuse, diffuse);
    return expose(light * (2.35 * body + (wetness * fresnel) * (0.42 * sheen + 20.0 * glint)) + 0.004 * colour);
}

// A normal with the relief of a texture. Tangents from the derivatives of the coordinates: the mesh bends, they bend
// along.
vec3 roughened(vec3 n, vec3 place, vec2 st, vec2 raised, float bump) {
    vec3 px = dFdx(place), py = dFdy(place);
    vec2 tx = dFdx(st), ty = dFdy(st);
    vec3 along = px * ty.y - py * tx.y, across = py * tx.x - px * ty.x;
    float scale = bump * sign(tx.x * ty.y - tx.y * ty.x) * inversesqrt(max(max(dot(along, along), dot(across, across)), 1e-24));
    return normalize(n + scale * (raised.x * along + raised.y * across));
}
)";

const char* const tissue_fragment = R"(
in vec3 place;
in vec3 facing;
in vec2 uv;
in vec3 arrived;
uniform vec3 lamp;
uniform sampler2D albedo;
uniform sampler2D relief;
uniform float bump;
uniform float rim_fade;   // mesentery: its edges grow thin and let the wall through
uniform int two_sided;    // a sheet: the side that is seen is the one that faces
out vec4 colour;
void main() {
    vec3 n = normalize(facing);
    vec3 to_eye = normalize(0.5 * lamp - place);
    n = dot(n, to_eye) < 0.0 && two_sided != 0 ? -n : n;
    vec4 texel = texture(albedo, uv);
    vec2 raised = texture(relief, uv).xy * 2.0 - 1.0;
    vec3 rough = roughened(n, place, uv, raised, bump);
    vec3 film = mix(n, rough, 0.62);
    vec3 own = texel.rgb * texel.rgb;
    own = mix(own, vec3(0.95, 0.72, 0.62), 0.75 * arrived.y);
    colour.rgb = wet(own, rough, film, to_eye, texel.a, arrived.x);
    colour.a = rim_fade > 0.0 ? 1.0 - smoothstep(1.0 - rim_fade, 1.0, arrived.z) : 1.0;
}
)";

const char* const sheet_fragment = R"(
in vec3 place;
in vec3 facing;
in vec2 uv;               // m at rest
in vec3 arrived;
#ifndef LIGHT_EACH_FRAGMENT
uniform vec3 lamp;
#endif
uniform sampler2D albedo;
uniform sampler2D relief;
uniform float bump;
uniform float tile;       // m
const float relief_height = 0.0009;  // m
#ifndef LAYERS
uniform vec3 cut_hue;     // linear: what a cut shows
#endif
uniform vec4 tint;        // linear colour and its share: what else than areolar tissue this is
#ifdef FIBRES
// Angel hair along the height, up to where the fat begins.
uniform float fat_from;   // m
uniform sampler2D fat;
uniform float fat_tile;   // m
#endif
#ifdef INK
uniform vec4 mark_from_to; // line at rest, m: from xy to zw
#endif
out vec4 colour;
void main() {
#ifdef SHADE_EACH_FRAGMENT
    vec2 light = shade(place);
#else
    vec2 light = arrived.xy;
#endif
#ifdef LIGHT_EACH_FRAGMENT
    light.x *= arriving(place);
#endif
#ifndef LIGHT_EACH_FRAGMENT
    // A face carries its char (its depth in a wall), a cut 4 more. What is large is never cut.
    float cut = step(2.0, arrived.z);
    float burnt = arrived.z - 4.0 * cut;
#endif
    vec3 n = normalize(facing);
    vec3 to_eye = normalize(0.5 * lamp - place);
    n = dot(n, to_eye) < 0.0 ? -n : n;
    vec2 st = uv / tile;
    vec4 texel = texture(albedo, st);
    vec3 px = dFdx(place), py = dFdy(place);
#ifdef LIGHT_EACH_FRAGMENT
    // What is so large takes its relief from its own brightness: a texture less to read.
    vec3 over = cross(py, n), aside = cross(n, px);
    float area = dot(px, over), turned = area < 0.0 ? -1.0 : 1.0;
    float height = relief_height * bump * (texel.r + texel.g);
    vec3 rough = normalize(abs(area) * n - turned * (dFdx(height) * over + dFdy(height) * aside));
#else
    vec2 raised = texture(relief, st).xy * 2.0 - 1.0;
    vec3 rough = roughened(n, place, st, raised, bump);
#endif
    vec3 own = texel.rgb * texel.rgb;
#ifdef FIBRES
    {
        // How far the height is drawn out: d place / d v.
        vec2 ux = dFdx(uv), uy = dFdy(uv);
        float turn = ux.x * uy.y - ux.y * uy.x;
        float stretch = length(py * ux.x - px * uy.x) / max(abs(turn), 1e-14);
        // Fibres run along the height, wander, and lie apart.
        float wander = texture(relief, vec2(uv.x, uv.y) / 0.031).a - 0.5;
        float coarse = texture(relief, vec2(uv.x / 0.013 + 0.35 * wander, uv.y / 0.15)).a;
        float fine = texture(relief, vec2(uv.x / 0.0052 - 0.30 * wander, uv.y / 0.09 + 0.37)).a;
        float strand = 0.55 * coarse + 0.45 * fine;
        float into_fat = smoothstep(fat_from - 0.0004, fat_from + 0.0006, uv.y);
        float thin = clamp((stretch - 1.05) * 0.55, 0.0, 1.0) * (1.0 - into_fat);
        // Between them the film gives way first.
        if (cut < 0.5 && strand < 0.30 + 0.22 * thin && thin > 0.02) discard;
        vec3 hair = mix(vec3(0.60, 0.42, 0.36), vec3(0.93, 0.89, 0.84), smoothstep(0.34, 0.62, strand));
        vec3 lobes = texture(fat, uv / fat_tile).rgb;
        own = mix(hair, lobes * lobes, into_fat);
    }
#endif
#ifdef INK
    // Ink, dashed: 6 mm drawn, 3 mm not.
    vec2 run = mark_from_to.zw - mark_from_to.xy;
    float reach = dot(run, run);
    float part = dot(uv - mark_from_to.xy, run) / reach;
    float off = distance(uv, mark_from_to.xy + clamp(part, 0.0, 1.0) * run);
    float dash = step(fract(part * sqrt(reach) / 0.009), 0.667);
    float ink = (1.0 - smoothstep(0.0005, 0.0008, off)) * dash * (1.0 - cut);
    own = mix(own, vec3(0.03, 0.05, 0.30), 0.85 * ink);
#endif
    vec3 film = mix(n, rough, 0.62);
    float wetness = texel.a;
#ifdef LIGHT_EACH_FRAGMENT
    own = mix(own, tint.rgb, tint.a);
#elif defined(LAYERS)
    {
        // By depth: serosa, pale muscle, a whitish layer, mucosa in folds across the bowel. Little light gets in.
        float depth = burnt;
        float wander = texture(relief, vec2(1.0, 2.0) * uv).a - 0.5;
        float fold = 0.5 + 0.5 * sin(6.2832 * (34.0 * uv.y + 0.5 * wander));
        vec3 mucosa = vec3(0.58, 0.15, 0.12) * (0.45 + 0.70 * sqrt(fold));
        vec3 layers = mix(vec3(0.70, 0.29, 0.22), vec3(0.86, 0.53, 0.42), smoothstep(0.48, 0.60, depth));
        layers = mix(layers, vec3(0.52, 0.12, 0.10), smoothstep(0.66, 0.82, depth));
        own = mix(mix(own, mucosa, depth), layers, cut);
        rough = mix(rough, n, cut);
        wetness *= 1.0 - 0.5 * cut;
        light.x *= 1.0 - (0.45 + 0.20 * cut) * depth;
    }
#else
    // A cut is paler and duller than the film over it.
    own = mix(own, cut_hue, cut);
    own = mix(own, tint.rgb, tint.a);
    // Char: first brown, then black and dry.
    own = mix(own, vec3(0.022, 0.016, 0.012), smoothstep(0.05, 0.45, burnt));
    rough = mix(rough, n, cut);
    wetness *= 1.0 - max(0.5 * cut, 0.85 * smoothstep(0.2, 0.6, burnt));
#endif
    own = mix(own, vec3(0.95, 0.72, 0.62), 0.75 * light.y);
    colour = vec4(wet(own, rough, film, to_eye, wetness, light.x), 1.0);
}
)";

const char* const wall_fragment = R"(
in vec3 place;
in vec3 facing;
in vec2 uv;
in vec3 arrived;
uniform mat4 to_camera;
uniform sampler2D albedo;
uniform sampler2D relief;   // to be added to the normal, patient frame
uniform float bump;
out vec4 colour;
void main() {
    vec3 n = normalize(facing);
    vec3 to_eye = normalize(0.5 * lamp - place);
    vec4 texel = texture(albedo, uv);
    vec3 raised = texture(relief, uv).xyz * 2.0 - 1.0;
    vec3 rough = normalize(n + bump * (mat3(to_camera) * raised));
    vec3 film = mix(n, rough, 0.6);
    vec3 own = texel.rgb * texel.rgb;
    own = mix(own, vec3(0.9, 0.75, 0.68), 0.6 * arrived.y);
    colour = vec4(wet(own, rough, film, to_eye, texel.a, arriving(place) * arrived.x), 1.0);
}
)";

const char* const plain_fragment = R"(
in vec3 place;
in vec3 facing;
in vec3 arrived;
uniform vec3 lamp;
uniform vec3 hue;
uniform vec3 accent;
uniform float lit;        // 0: lines
out vec4 colour;
void main() {
    vec3 own = mix(hue, accent, clamp(arrived.z, 0.0, 1.0));
    vec3 n = normalize(facing + vec3(0.0, 0.0, 1e-9));
    n = dot(n, place) > 0.0 ? -n : n;
    colour = vec4(lit > 0.5 ? wet(own, n, n, normalize(lamp - place), 0.10, arrived.x) : own, 1.0);
}
)";

const char* const box_fragment = R"(
in vec3 place;
in vec3 facing;
in vec2 uv;
out vec4 colour;
void main() {
    vec3 n = normalize(facing);
    // Lines every 20 mm: something to judge depth by.
    vec2 cell = abs(fract(uv * 50.0) - 0.5);
    vec2 width = fwidth(uv * 50.0);
    vec2 line = smoothstep(vec2(0.5) - 1.5 * width - 0.012, vec2(0.5), cell);
    float drawn = max(line.x, line.y) * clamp(0.30 / max(width.x, width.y) - 0.5, 0.0, 1.0);
    vec3 own = mix(vec3(0.11, 0.15, 0.17), vec3(0.26, 0.32, 0.34), drawn);
    // The walls are large triangles: light and shadow for each fragment.
    vec2 shaded = shade(place);
    colour = vec4(wet(own, n, n, normalize(0.5 * lamp - place), 0.08, arriving(place) * shaded.x), 1.0);
}
)";

const char* const ghost_fragment = R"(
in vec3 place;
in vec3 facing;
uniform vec4 tint;         // colour and opacity
out vec4 colour;
void main() {
    float rim = 1.0 - abs(dot(normalize(facing), normalize(place)));
    colour = vec4(tint.rgb * (0.5 + 0.5 * rim), tint.a * (0.35 + 0.65 * rim));
}
)";

const char* const hard = R"(
// What is hard and dry: how the lamp strikes it.
in vec3 place;
in vec3 facing;
out vec4 colour;
struct Struck {
    vec3 n, to_lamp, to_eye;
    float light;    // that arrives
    float across;   // cosine of the normal to the way half between lamp and eye
};
Struck struck(vec3 n) {
    vec3 to_lamp = normalize(lamp - place), to_eye = normalize(-place);
    return Struck(n, to_lamp, to_eye, 0.40 * arriving(place), max(dot(n, normalize(to_lamp + to_eye)), 0.0));
}
// mark: the alpha that tells it from what is next to it (edge_smoothing.h).
void show(vec3 linear, float mark) {
    colour = vec4(expose(linear + 0.003), mark);
}
)";

const char* const insulated_fragment = R"(
void main() {
    // Black plastic.
    Struck at = struck(normalize(facing));
    float a2 = at.across * at.across, a4 = a2 * a2, a8 = a4 * a4, a16 = a8 * a8;
    float rim = 1.0 - max(dot(at.n, at.to_eye), 0.0);
    show(at.light * (vec3(0.055, 0.056, 0.060) * max(dot(at.n, at.to_lamp), 0.0) * 3.0 +
                     vec3(0.75, 0.78, 0.82) * (a16 * a16 * a16) +
                     vec3(0.20, 0.12, 0.10) * rim * rim * rim * 0.25), 0.25);
}
)";

const char* const steel_fragment = R"(
in vec2 uv;
uniform sampler2D albedo;
uniform sampler2D relief;
uniform vec3 hue;          // linear, of what the steel is coated with: 1 nothing
void main() {
    vec3 n = normalize(facing);
    vec4 texel = texture(albedo, uv);
    vec2 raised = texture(relief, uv).xy * 2.0 - 1.0;
    vec3 px = dFdx(place), py = dFdy(place);
    vec2 tx = dFdx(uv), ty = dFdy(uv);
    vec3 along = px * ty.y - py * tx.y, around = py * tx.x - px * ty.x;
    float scale = 0.35 * inversesqrt(max(dot(along, along), 1e-24));
    vec3 rough = normalize(n + scale * (raised.x * along + raised.y * around));
    vec3 steel = texel.rgb * texel.rgb * hue;
    // Brushed along the shaft: highlights drawn out across the strokes.
    Struck at = struck(rough);
    float broad = pow(at.across, 14.0);
    float sharp = pow(at.across, 160.0);
    // The tissue all round mirrors in it.
    vec3 mirrored = mix(vec3(0.30, 0.11, 0.08), vec3(0.42, 0.25, 0.20), n.y * 0.5 + 0.5);
    float facing_ratio = max(dot(n, at.to_eye), 0.0);
    show(at.light * steel * (vec3(1.1) * max(dot(n, at.to_lamp), 0.0) + 1.9 * broad + 6.0 * sharp +
                             1.5 * mirrored * (1.15 - facing_ratio)), 0.0);
}
)";

const char* const target_fragment = R"(
in vec3 place;
in vec3 facing;
in vec3 own;
uniform vec3 hue;
uniform float glow;        // 0 .. 1: the one to touch now
uniform float bands;       // 0: none, 1: left, 2: right, distinguished without colour
uniform float opacity;
out vec4 colour;
void main() {
    vec3 n = normalize(facing);
    float height = own.z;
    float band = bands < 0.5 ? 1.0 : bands < 1.5 ? abs(height) : abs(abs(height) - 0.34);
    float painted = 1.0 - smoothstep(0.10, 0.14, band);
    vec3 c = mix(hue, vec3(0.93), painted);
    c *= c;
    vec3 lit = wet(c, n, n, normalize(0.5 * lamp - place), 0.5, 0.8 * arriving(place) * shade(place).x);
    float rim = 1.0 - max(dot(n, normalize(-place)), 0.0);
    lit += glow * (0.22 * hue + 0.5 * rim * rim * vec3(1.0, 0.97, 0.85));
    colour = vec4(lit, opacity < 1.0 ? opacity : 0.5);
}
)";

const char* const mask_vertex = R"(
layout(location = 0) in vec3 position;
void main() {
    gl_Position = vec4(position.xy, -1.0, 1.0);   // at the near plane: the mask hides everything behind it
}
)";

const char* const mask_fragment = R"(
out vec4 colour;
void main() {
    colour = vec4(0.0, 0.0, 0.0, 1.0);
}
)";

}  // namespace fulcrum::ui::shaders
