// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/rod_study.h"

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/rod/rod.h"

namespace fulcrum {
namespace {

using nlohmann::json;

class Reader {
  public:
    Reader(const json& study, std::string file) : study_(study), file_(std::move(file)) {
        if (!study_.is_object())
            throw InputError(file_, "/", "a study must be a JSON object", "write {\"model\": \"rod\", ...}");
    }
    [[noreturn]] void fail(const std::string& place, const std::string& wrong,
                           const std::string& hint) const {
        throw InputError(file_, place, wrong, hint);
    }
    double finite(const json& value, const std::string& place) const {
        if (!value.is_number()) fail(place, "the value must be a number", "write it in SI units");
        const double number = value.get<double>();
        if (!std::isfinite(number) || std::fabs(number) > 1e12)
            fail(place, "the value is out of range", "give a finite number up to 1e12");
        return number;
    }
    double number(const char* key, double fallback) const {
        return study_.contains(key) ? finite(study_.at(key), "/" + std::string(key)) : fallback;
    }
    double number(const char* key) const {
        if (!study_.contains(key)) fail("/" + std::string(key), "the key is missing", "add it");
        return finite(study_.at(key), "/" + std::string(key));
    }
    int integer(const char* key) const {
        const double value = number(key);
        if (value != std::floor(value) || value < 2 || value > 4096)
            fail("/" + std::string(key), "the value must be a whole number from 2 to 4096", "change it");
        return static_cast<int>(value);
    }
    std::string text(const char* key, const std::string& fallback) const {
        if (!study_.contains(key)) return fallback;
        if (!study_.at(key).is_string())
            fail("/" + std::string(key), "the value must be a string", "put it in quotes");
        return study_.at(key).get<std::string>();
    }
    Vector3 vector(const json& value, const std::string& place) const {
        if (!value.is_array() || value.size() != 3)
            fail(place, "the value must be three numbers", "write [x, y, z]");
        return Vector3(finite(value[0], place + "/0"), finite(value[1], place + "/1"),
                       finite(value[2], place + "/2"));
    }
    Vector3 vector(const char* key) const {
        return study_.contains(key) ? vector(study_.at(key), "/" + std::string(key))
                                    : Vector3(Vector3::Zero());
    }
    const json& operator[](const char* key) const { return study_.at(key); }
    bool has(const char* key) const { return study_.contains(key); }

  private:
    const json& study_;
    std::string file_;
};

RodEnd end_of(const Reader& reader, const json& value, const std::string& place) {
    const std::string name = value.is_string() ? value.get<std::string>() : "";
    if (name == "clamped") return RodEnd::clamped;
    if (name == "pinned") return RodEnd::pinned;
    if (name == "free") return RodEnd::free;
    if (name == "held") return RodEnd::held;
    reader.fail(place, "this is not an end condition", "use \"clamped\", \"pinned\", \"free\" or \"held\"");
}

json row(const Vector3& v) {
    return json::array({v.x(), v.y(), v.z()});
}

struct Case {
    RodSpec spec;
    RodInputs inputs;
    RodSolve solve;
    double twist = 0;  // of the far end, rad
    Vector3 moved = Vector3::Zero();
};

// Layers of the wall, lumen first, instead of inner_radius_m and young_pa.
void read_layers(const Reader& reader, RodSpec& spec) {
    if (!reader.has("layers")) return;
    const json& layers = reader["layers"];
    if (!layers.is_array() || layers.empty() || layers.size() > 8)
        reader.fail("/layers", "the value must be a list of 1 to 8 layers",
                    "write [{\"thickness_m\": .., \"young_pa\": ..}]");
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const std::string place = "/layers/" + std::to_string(i);
        const json& layer = layers[i];
        if (!layer.is_object() || !layer.contains("thickness_m") || !layer.contains("young_pa"))
            reader.fail(place, "a layer must have thickness_m and young_pa",
                        "write {\"thickness_m\": .., \"young_pa\": ..}");
        WallLayer wall;
        wall.thickness = reader.finite(layer.at("thickness_m"), place + "/thickness_m");
        wall.young = reader.finite(layer.at("young_pa"), place + "/young_pa");
        wall.exponent = layer.contains("exponent") ? reader.finite(layer.at("exponent"), place + "/exponent")
                                                   : spec.exponent;
        spec.layers.push_back(wall);
    }
}

Case read(const Reader& reader) {
    Case c;
    RodSpec& spec = c.spec;
    spec.length = reader.number("length_m");
    spec.segments = reader.integer("segments");
    spec.outer_radius = reader.number("outer_radius_m", 0.015);
    spec.inner_radius = reader.number("inner_radius_m", 0.012);
    spec.young_modulus = reader.number("young_pa", 32.3e3);
    spec.poisson_ratio = reader.number("poisson", 0.35);
    spec.linear_density = reader.number("linear_density_kg_m", 0.25);
    const std::string law = reader.text("law", "linear");
    if (law == "exp2") {
        spec.law = MaterialLaw::exp2;
        spec.young_modulus = reader.number("young_pa", Exp2{}.rest_stiffness);
    } else if (law != "linear") {
        reader.fail("/law", "unknown law", "use \"linear\" or \"exp2\"");
    }
    spec.exponent = reader.number("exponent", Exp2{}.exponent);
    read_layers(reader, spec);
    const std::string level = reader.text("level", "newton");
    if (level == "linearised") {
        c.solve.level = RodSolve::Level::linearised;
    } else if (level != "newton") {
        reader.fail("/level", "unknown level", "use \"linearised\" or \"newton\"");
    }
    if (reader.has("iterations")) c.solve.iterations = static_cast<int>(reader.number("iterations"));
    if (reader.has("ends")) {
        const json& ends = reader["ends"];
        if (!ends.is_array() || ends.size() != 2)
            reader.fail("/ends", "the value must be two end conditions", "write [\"clamped\", \"free\"]");
        for (std::size_t e = 0; e < 2; ++e)
            spec.ends[e] = end_of(reader, ends[e], "/ends/" + std::to_string(e));
    } else {
        spec.ends[0] = RodEnd::clamped;
    }
    const Vector3 natural = reader.vector("intrinsic_curvature_per_m");
    for (int k = 0; k < 3; ++k) spec.intrinsic_curvature[k] = natural[k];
    c.twist = reader.number("end_twist_rad", 0);
    c.moved = reader.vector("end_displacement_m");
    c.inputs.gravity = reader.vector("gravity");
    return c;
}

// A load between nodes is distributed linearly.
void add_point_loads(const Reader& reader, const Rod& rod, RodInputs& inputs) {
    if (!reader.has("point_loads")) return;
    const json& loads = reader["point_loads"];
    if (!loads.is_array() || loads.size() > 10000)
        reader.fail("/point_loads", "the value must be a list of at most 10000 loads",
                    "write [{\"s_m\": .., \"force_n\": [x, y, z]}]");
    const auto n = static_cast<std::size_t>(rod.segments());
    inputs.nodal_forces.assign(n + 1, Vector3::Zero());
    for (std::size_t i = 0; i < loads.size(); ++i) {
        const std::string place = "/point_loads/" + std::to_string(i);
        const json& load = loads[i];
        if (!load.is_object() || !load.contains("s_m") || !load.contains("force_n")) {
            reader.fail(place, "a load must have s_m and force_n",
                        "write {\"s_m\": .., \"force_n\": [x, y, z]}");
        }
        const double s = reader.finite(load.at("s_m"), place + "/s_m");
        if (s < 0 || s > rod.length() * (1 + 1e-12))
            reader.fail(place + "/s_m", "the load is outside the rod", "give 0 to length_m");
        const Vector3 force = reader.vector(load.at("force_n"), place + "/force_n");
        const double x = std::min(s / rod.length(), 1.0) * static_cast<double>(n);
        const std::size_t j = std::min(n - 1, static_cast<std::size_t>(x));
        const double u = x - static_cast<double>(j);
        inputs.nodal_forces[j] += (1 - u) * force;
        inputs.nodal_forces[j + 1] += u * force;
    }
}

bool finite_result(const RodState& state, const RodReport& report) {
    return report.finite && Rod::finite(state);
}

json result_of(const Rod& rod, const RodState& state, const RodInputs& inputs, const RodReport& report) {
    json result;
    json nodes = json::array(), twist = json::array();
    for (const Vector3& node : state.nodes) nodes.push_back(row(node));
    double angle = 0;
    for (std::size_t j = 0; j < state.joint_twist.size() - 1; ++j) {
        angle += state.joint_twist[j];
        twist.push_back(angle);
    }
    RodEnergy energy = rod.energy(state, inputs);
    result["nodes"] = nodes;
    result["twist_rad"] = twist;
    result["energy_j"] = {{"bend", energy.bend},
                          {"twist", energy.twist},
                          {"stretch", energy.stretch},
                          {"external", energy.external}};
    result["reaction_n"] = json::array({row(report.end_force[0]), row(report.end_force[1])});
    result["reaction_nm"] = json::array({row(report.end_moment[0]), row(report.end_moment[1])});
    result["residual"] = report.residual;
    result["converged"] = report.converged;
    result["positive_definite"] = report.positive_definite;
    result["finite"] = finite_result(state, report);
    return result;
}

}  // namespace

json run_rod_study(const json& study, const std::string& file) {
    const Reader reader(study, file);
    Case c = read(reader);
    std::unique_ptr<Rod> made;
    try {
        made = std::make_unique<Rod>(c.spec);
    } catch (const std::invalid_argument& error) {
        reader.fail("/", error.what(), "change the value");
    }
    const Rod& rod = *made;
    add_point_loads(reader, rod, c.inputs);
    RodState state = rod.make_state();
    RodScratch scratch = rod.make_scratch();
    RodInputs& inputs = c.inputs;
    inputs.ends[0] = state.ends[0];
    inputs.ends[1] = state.ends[1];
    const RodFrame rest = state.ends[1];
    const bool driven = c.spec.ends[1] != RodEnd::free && (c.twist != 0 || !c.moved.isZero(0));
    if (c.spec.ends[1] == RodEnd::free && (c.twist != 0 || !c.moved.isZero(0))) {
        reader.fail("/ends/1", "a free end cannot be twisted or moved",
                    "hold it, or omit end_twist_rad and end_displacement_m");
    }

    const auto start = std::chrono::steady_clock::now();
    // A driven end moves to its target in parts: a turn of more than half a revolution is ambiguous as a
    // frame, and a straight rod compressed in one step would be pushed through itself.
    int parts = 1;
    if (driven) {
        const double turns = std::fabs(c.twist) / 0.25,
                     moves = 2 * c.moved.norm() / rod.length() * rod.segments() / 4;
        parts = 1 + static_cast<int>(std::min(2000.0, std::ceil(std::max(turns, moves))));
    }
    RodReport report;
    int iterations = 0;
    if (c.solve.level == RodSolve::Level::linearised && !driven) {
        // k equal load steps, one linear system each, about the previous state.
        const int steps = std::max(1, std::min(c.solve.iterations, 100000));
        RodSolve one = c.solve;
        one.iterations = 1;
        const Vector3 gravity = inputs.gravity;
        const std::vector<Vector3> forces = inputs.nodal_forces;
        for (int k = 1; k <= steps; ++k) {
            const double share = static_cast<double>(k) / steps;
            inputs.gravity = gravity * share;
            for (std::size_t i = 0; i < forces.size(); ++i) inputs.nodal_forces[i] = forces[i] * share;
            report = rod.solve(state, inputs, scratch, one);
            iterations += report.iterations;
        }
    } else {
        for (int k = 1; k <= parts; ++k) {
            const double share = static_cast<double>(k) / parts, angle = c.twist * share;
            const Vector3 axis = rest.rotation.col(2), d1 = rest.rotation.col(0), d2 = rest.rotation.col(1);
            inputs.ends[1].position = rest.position + c.moved * share;
            inputs.ends[1].rotation.col(0) = d1 * math::cos(angle) + d2 * math::sin(angle);
            inputs.ends[1].rotation.col(1) = axis.cross(Vector3(inputs.ends[1].rotation.col(0)));
            report = rod.solve(state, inputs, scratch, c.solve);
            iterations += report.iterations;
        }
    }
    const double time =
        std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - start).count();

    json result = result_of(rod, state, inputs, report);
    result["iterations"] = iterations;
    result["time_us"] = time;
    return result;
}

}  // namespace fulcrum
