// SPDX-License-Identifier: GPL-3.0-or-later
// All lighting happens in camera space: the light sits beside the lens, so most of it is a function of the
// fragment's own place. Cost counts: everything here also runs on a processor.
#include "ui/theatre/renderer/shaders.h"

namespace fulcrum::ui::shaders {

const char* const head = "#version 330 core\n";

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
out float share;     // fat beneath, or fraction along the mesentery
out vec3 body;       // patient frame
out vec3 body_normal;
void main() {
    vec4 p = to_camera * vec4(position, 1.0);
    place = p.xyz;
    facing = mat3(to_camera) * normal;
    uv = coordinates;
    share = detail;
    body = position;
    body_normal = normal;
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

const char* const light = R"(
uniform vec3 lamp;            // camera space
uniform float brightness;
uniform vec4 shadow_from[4];  // camera space; w: strength of the contact shadow
uniform vec4 shadow_to[4];    // w: radius
uniform vec4 strain;          // per tool
uniform int shadows;

// Squared distance from p to the segment ab.
float segment_distance(vec3 p, vec3 a, vec3 b) {
    vec3 ab = b - a, ap = p - a;
    vec3 off = ap - clamp(dot(ap, ab) / dot(ab, ab), 0.0, 1.0) * ab;
    return dot(off, off);
}

// What instruments take away: x the share of light that arrives, y how much tissue is squeezed pale.
vec2 shade(vec3 p) {
    float lit = 1.0;
    float pale = 0.0;
    for (int i = 0; i < shadows; ++i) {
        vec3 a = shadow_from[i].xyz, b = shadow_to[i].xyz;
        float r = shadow_to[i].w;
        // Contact: what lies close to the jaws is closed in by them.
        float d2 = segment_distance(p, a, b);
        float near_tip = exp2(-1.2 * d2 / (r * r));
        // Shadow: the tip thrown onto the tissue along the ray of a lamp that sits a little higher than it does.
        vec3 from = lamp + vec3(0.0, 0.016, 0.0);
        vec3 ray = normalize(p - from);
        vec3 tip = b - from;
        float along = dot(tip, ray);
        vec3 off = tip - along * ray;
        float gap = max(distance(p, from) - along, 0.0);
        float width = 0.8 * r + 0.12 * gap;
        float thrown = exp2(-1.4 * dot(off, off) / (width * width)) * exp2(-gap * 22.0);
        lit *= 1.0 - shadow_from[i].w * (0.62 * near_tip + 0.48 * thrown * (1.0 - near_tip));
        pale += strain[i] * exp2(-d2 / (0.006 * 0.006));
    }
    return vec2(lit, pale);
}

// Light that arrives at p: bright centre, fall-off with distance.
float arriving(vec3 p, vec3 to_lamp) {
    float d2 = dot(to_lamp, to_lamp);
    float fall = 1.0 / (1.0 + d2 * 130.0 + d2 * d2 * 5200.0);
    float axis = -p.z * inversesqrt(dot(p, p));
    float beam = smoothstep(0.72, 1.0, axis);
    return brightness * fall * (0.50 + 0.62 * beam);
}

// Linear light to the screen: a soft shoulder, then gamma 2.
vec3 expose(vec3 c) {
    c = c * (1.0 + c * 0.10) / (1.0 + c);
    return sqrt(c);
}

// A wet surface under the lamp. The film reflects twice: a broad sheen and a sharp glint.
vec3 wet(vec3 colour, vec3 n, vec3 film, vec3 p, float wetness, vec2 shaded) {
    vec3 to_lamp = lamp - p;
    vec3 l = normalize(to_lamp);
    vec3 v = normalize(-p);
    float light = arriving(p, to_lamp) * shaded.x;
    float raw = dot(n, l);
    float diffuse = max(raw, 0.0);
    float soft = max(raw * 0.8 + 0.2, 0.0);
    vec3 h = normalize(l + v);
    float across = max(dot(film, h), 0.0);
    float a2 = across * across;
    float a4 = a2 * a2;
    float a8 = a4 * a4;
    float a16 = a8 * a8;
    float sheen = a16 * a16;
    float s64 = sheen * sheen;
    float s256 = s64 * s64; s256 *= s256;
    float glint = s256 * s256;
    float rim = 1.0 - max(dot(n, v), 0.0);
    float fresnel = 0.35 + 0.65 * rim * rim;
    // Blood beneath carries red light sideways into the half-shade.
    vec3 body = colour * mix(vec3(diffuse), vec3(soft, diffuse, diffuse), 0.35);
    vec3 linear = light * (6.2 * body + wetness * fresnel * (vec3(0.42, 0.40, 0.40) * sheen + vec3(9.0, 9.2, 9.6) * glint));
    return expose(linear + 0.006 * colour);
}

// Turns a normal by a tangent-space normal with tangents from the derivatives of the coordinates.
vec3 turned(vec3 n, vec3 p, vec2 t, vec3 bump, float strength) {
    vec3 px = dFdx(p), py = dFdy(p);
    vec2 tx = dFdx(t), ty = dFdy(t);
    vec3 across = cross(py, n), along = cross(n, px);
    vec3 tangent = across * tx.x + along * ty.x;
    vec3 other = across * tx.y + along * ty.y;
    float scale = inversesqrt(max(max(dot(tangent, tangent), dot(other, other)), 1e-20));
    return normalize(n + strength * scale * (tangent * bump.x + other * bump.y));
}
)";

const char* const tissue_fragment = R"(
in vec3 place;
in vec3 facing;
in vec2 uv;
in float share;
uniform sampler2D albedo;
uniform sampler2D relief;
uniform float bump;
uniform float rim_fade;   // mesentery: its edges grow thin and let the wall through
out vec4 colour;
void main() {
    vec3 n = normalize(facing);
    if (dot(n, place) > 0.0) n = -n;
    vec4 texel = texture(albedo, uv);
    vec3 raised = texture(relief, uv).xyz * 2.0 - 1.0;
    vec3 rough = turned(n, place, uv, raised, bump);
    vec3 film = normalize(mix(n, rough, 0.55));
    vec2 shaded = shade(place);
    vec3 own = texel.rgb * texel.rgb;
    own = mix(own, vec3(0.95, 0.72, 0.62), min(0.75 * shaded.y, 0.75));
    colour = vec4(wet(own, rough, film, place, texel.a, shaded), 1.0);
    if (rim_fade > 0.0) colour.a = mix(1.0, 0.0, smoothstep(1.0 - rim_fade, 1.0, share));
}
)";

const char* const wall_fragment = R"(
in vec3 place;
in vec3 facing;
in vec2 uv;
in float share;
in vec3 body;
in vec3 body_normal;
uniform sampler2D albedo;
uniform sampler2D relief;
uniform float bump;
uniform int blended;   // 0: coordinates of the triangle's own plane; 1: three planes
out vec4 colour;
const float tile = 1.0 / 0.12;
void main() {
    vec3 n = normalize(facing);
    vec4 texel;
    vec3 rough;
    if (blended == 0) {
        texel = texture(albedo, uv);
        rough = turned(n, place, uv, texture(relief, uv).xyz * 2.0 - 1.0, bump);
    } else {
        vec3 w = abs(normalize(body_normal));
        w = max(w - 0.40, 0.0);
        w /= w.x + w.y + w.z;
        vec2 x = body.yz * tile, y = body.zx * tile, z = body.xy * tile;
        texel = w.x * texture(albedo, x) + w.y * texture(albedo, y) + w.z * texture(albedo, z);
        vec3 a = turned(n, place, x, texture(relief, x).xyz * 2.0 - 1.0, bump);
        vec3 b = turned(n, place, y, texture(relief, y).xyz * 2.0 - 1.0, bump);
        vec3 c = turned(n, place, z, texture(relief, z).xyz * 2.0 - 1.0, bump);
        rough = normalize(w.x * a + w.y * b + w.z * c);
    }
    vec3 film = normalize(mix(n, rough, 0.5));
    vec2 shaded = shade(place);
    vec3 own = texel.rgb * texel.rgb;
    // Fat beneath the film: yellow where there is much of it.
    own = mix(own, own * vec3(1.10, 1.02, 0.62) + vec3(0.10, 0.055, 0.0), share * 0.8);
    own = mix(own, vec3(0.9, 0.75, 0.68), min(0.6 * shaded.y, 0.6));
    colour = vec4(wet(own, rough, film, place, 0.8 * texel.a, shaded), 1.0);
}
)";

const char* const box_fragment = R"(
in vec3 place;
in vec3 facing;
in vec2 uv;
in vec3 body;
out vec4 colour;
void main() {
    vec3 n = normalize(facing);
    // Lines every 20 mm: something to judge depth by.
    vec2 cell = abs(fract(uv * 50.0) - 0.5);
    vec2 width = fwidth(uv * 50.0);
    vec2 line = smoothstep(vec2(0.5) - 1.5 * width - 0.012, vec2(0.5), cell);
    float drawn = max(line.x, line.y) * clamp(0.30 / max(width.x, width.y) - 0.5, 0.0, 1.0);
    vec3 own = mix(vec3(0.16, 0.20, 0.23), vec3(0.34, 0.40, 0.43), drawn);
    vec2 shaded = shade(place);
    colour = vec4(wet(own, n, n, place, 0.10, shaded), 1.0);
}
)";

const char* const steel_fragment = R"(
in vec3 place;
in vec3 facing;
in vec2 uv;
in vec3 own;
uniform sampler2D albedo;
uniform sampler2D relief;
uniform float insulated;   // 1: black plastic, 0: steel
uniform vec4 tint;         // ghost: colour and opacity
out vec4 colour;
void main() {
    vec3 n = normalize(facing);
    if (tint.a < 1.0) {
        float rim = 1.0 - abs(dot(n, normalize(place)));
        colour = vec4(tint.rgb * (0.5 + 0.5 * rim), tint.a * (0.35 + 0.65 * rim));
        return;
    }
    vec3 to_lamp = lamp - place;
    vec3 l = normalize(to_lamp);
    vec3 v = normalize(-place);
    float light = arriving(place, to_lamp);
    vec3 h = normalize(l + v);
    float lambert = max(dot(n, l), 0.0);
    vec3 linear;
    if (insulated > 0.5) {
        float across = max(dot(n, h), 0.0);
        float gloss = pow(across, 48.0);
        float rim = 1.0 - max(dot(n, v), 0.0);
        linear = light * (vec3(0.055, 0.056, 0.060) * lambert * 3.0 + vec3(0.75, 0.78, 0.82) * gloss +
                          vec3(0.20, 0.12, 0.10) * rim * rim * rim * 0.25);
    } else {
        vec4 texel = texture(albedo, uv);
        vec3 rough = turned(n, place, uv, texture(relief, uv).xyz * 2.0 - 1.0, 0.35);
        vec3 steel = texel.rgb * texel.rgb;
        // Brushed along the shaft: highlights drawn out across the strokes.
        float across = max(dot(rough, h), 0.0);
        float broad = pow(across, 14.0);
        float sharp = pow(across, 160.0);
        // The tissue all round mirrors in it.
        float up = n.y * 0.5 + 0.5;
        vec3 mirrored = mix(vec3(0.30, 0.11, 0.08), vec3(0.42, 0.25, 0.20), up);
        float facing_ratio = max(dot(n, v), 0.0);
        linear = light * steel * (vec3(1.1) * lambert + 1.9 * broad + 6.0 * sharp + 1.5 * mirrored * (1.15 - facing_ratio));
    }
    colour = vec4(expose(linear + 0.003), 1.0);
}
)";

const char* const target_fragment = R"(
in vec3 place;
in vec3 facing;
in vec3 own;
uniform vec3 hue;
uniform float glow;        // 0 .. 1: the one to touch now
uniform float bands;       // 1: left, 2: right, told apart without colour
uniform float opacity;
out vec4 colour;
void main() {
    vec3 n = normalize(facing);
    float height = own.z;
    float band = bands < 1.5 ? abs(height) : abs(abs(height) - 0.34);
    float painted = 1.0 - smoothstep(0.10, 0.14, band);
    vec3 c = mix(hue, vec3(0.93), painted);
    c *= c;
    vec2 shaded = shade(place);
    vec3 lit = wet(c, n, n, place, 0.55, shaded);
    float rim = 1.0 - max(dot(n, normalize(-place)), 0.0);
    lit += glow * (0.22 * hue + 0.5 * rim * rim * vec3(1.0, 0.97, 0.85));
    colour = vec4(lit, opacity);
}
)";

const char* const screen_vertex = R"(
layout(location = 0) in vec3 position;
out vec2 at;
uniform vec2 reach;   // half size of the frame in units of the image's radius
void main() {
    vec2 corner = position.xy;
    at = corner * reach;
    gl_Position = vec4(corner, -1.0, 1.0);   // at the near plane: the mask hides everything behind it
}
)";

const char* const screen_fragment = R"(
in vec2 at;
uniform sampler2D image;
uniform float pixel;      // of the frame, in units of the image's radius
uniform float hidden;
out vec4 colour;
void main() {
    float r = length(at);
    // The fibre's own vignette, then the black frame with a soft rim and a small mark for the horizon.
    float inside = 1.0 - smoothstep(0.985 - pixel, 0.985 + pixel, r);
    float vignette = 1.0 - 0.55 * smoothstep(0.55, 1.02, r);
    vec2 mark = vec2(at.x, at.y - 0.985);
    float notch = 1.0 - smoothstep(0.022, 0.026, abs(mark.x) + max(mark.y, -mark.y));
    vec3 c = texture(image, at * 0.5 + 0.5).rgb * vignette * inside * (1.0 - notch) * (1.0 - hidden);
    colour = vec4(c, 1.0);
}
)";

}  // namespace fulcrum::ui::shaders
