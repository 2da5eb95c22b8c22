// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/stability_map.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "sim_core/haptics/stability.h"
#include "sim_core/lab/contact_run.h"
#include "sim_core/lab/reference_tube.h"
#include "sim_core/numerics/functions.h"

namespace fulcrum::lab {
namespace {

constexpr double tube_length = 0.4, tube_radius = 0.016;
constexpr double pi = 3.14159265358979323846;
constexpr double working_depth = 0.003;  // m, of the constant load
constexpr double disturbance = 0.0003;   // m
constexpr int settle_ticks = 500, run_ticks = 4500;

/// Exact motion of a damped mass (k = 0) or of one on a spring over one period under a held force.
struct MotionLaw {
    // x+ = a11 x + a12 v + g1 f, v+ = a21 x + a22 v + g2 f, x from the end of the spring, f without the
    // spring's
    double a11 = 1, a12 = 0, a21 = 0, a22 = 1, g1 = 0, g2 = 0;

    MotionLaw(double mass, double damping, double spring, double period) {
        // Sixteen terms of the exponential of the 3 x 3 block [A b; 0 0] T, subdivided so that they suffice.
        double largest = std::sqrt(spring / mass) + damping / mass;
        int parts = 1;
        while (largest * period / parts > 0.5) parts *= 2;
        const double h = period / parts;
        Matrix3 rate = Matrix3::Zero();
        rate << 0, h, 0, -spring / mass * h, -damping / mass * h, h / mass, 0, 0, 0;
        Matrix3 term = Matrix3::Identity(), sum = term;
        for (int n = 1; n <= 16; ++n) {
            term = Matrix3(term * rate) / n;
            sum += term;
        }
        for (int n = parts; n > 1; n /= 2) sum = Matrix3(sum * sum);
        a11 = sum(0, 0), a12 = sum(0, 1), g1 = sum(0, 2);
        a21 = sum(1, 0), a22 = sum(1, 1), g2 = sum(1, 2);
    }
};

}  // namespace

struct DeviceAtContact::Parts : ToolOnSkin {
    SimulatedDevice device;
    std::vector<double> waiting;  // delayed positions
    double footprint = 0;         // m2, K over the wall's stiffness per area
    double damping = 0;

    // The tick at depth x below the crest: force on the device along the outward normal, N.
    double force(double depth) {
        const double step = device.encoder_step;
        depth = step * std::round(depth / step);
        waiting.push_back(depth);
        const double seen = waiting.front();
        waiting.erase(waiting.begin());
        const Vector3 tip(0.5 * tube_length, 0, tube_radius + model.instrument.tip_radius - seen);
        DeviceReading reading;
        reading.handle = handle_for_tip(model.instrument.trocar, tip);
        const ToolKinematics tool =
            step_instrument(model.instrument, quantise(reading, instrument.last), instrument);
        step_tool_contact(model, local, tool, local.tick, state, tick_scratch, result);
        return -result.force.z();
    }
    void start(double stiffness, double tissue_damping, double depth) {
        damping = tissue_damping;
        state = ToolContactState{};
        instrument = InstrumentState{};
        waiting.assign(static_cast<std::size_t>(device.delay_ticks), depth);
        TissueContact& contact = local.patch.contact;
        contact.stiffness_per_area = stiffness / footprint;
        contact.least_stiffness = 0;
        contact.most_stiffness = 1e9;
        contact.damping = tissue_damping;
        contact.friction = 0;
    }
    bool dies_out(const MotionLaw& law, double stiffness, double tissue_damping, bool& finite);
    double energy_of(double stiffness, double tissue_damping, double frequency, double amplitude);
};

DeviceAtContact::DeviceAtContact(FilterMode grade, const SimulatedDevice& device) : parts_(new Parts) {
    Parts& parts = *parts_;
    parts.device = device;
    TriangleMesh mesh = make_tube(tube_length, 170, 45, plain_radius(tube_radius));
    Cage cage =
        build_cage(mesh, tube_length, sample_spheres(tube_length, 0.016, [](double) { return tube_radius; }));
    parts.skin = std::make_unique<BowelSkin>(std::move(mesh), std::move(cage));
    parts.builder = std::make_unique<PatchBuilder>(*parts.skin, PatchOptions{});
    parts.scratch = parts.builder->make_scratch();
    parts.rings.resize(static_cast<std::size_t>(parts.skin->rings()));
    for (std::size_t r = 0; r < parts.rings.size(); ++r)
        parts.rings[r].frame = rest_frame(parts.skin->cage().arc_lengths[r]);
    InstrumentSpec spec;
    spec.trocar.position = Vector3(0.5 * tube_length, 0.0, 0.2);
    spec.trocar.direction = Vector3(0, 0, -1);
    spec.trocar.up = Vector3(0, 1, 0);
    parts.model.instrument = make_instrument(spec, device.period);
    parts.model.filter.mode = grade;
    PatchRequest request;
    DeviceReading reading;
    reading.handle =
        handle_for_tip(parts.model.instrument.trocar, Vector3(0.5 * tube_length, 0, tube_radius));
    request.tool = tool_pose(parts.model.instrument, quantise(reading, DeviceSample{}));
    parts.local.step = 1;
    parts.builder->build(parts.rings.data(), request, parts.scratch, parts.local);
    // Area covered by the filter's footprint: K is proportional to the wall's stiffness per area.
    parts.footprint = 1.0;
    parts.start(1.0, 0, working_depth);
    parts.force(working_depth);
    parts.footprint = parts.state.stiffness;
}

DeviceAtContact::~DeviceAtContact() {
    delete parts_;
}

// Displaced from equilibrium and released: true if the oscillation has decayed by the end of the run.
bool DeviceAtContact::Parts::dies_out(const MotionLaw& law, double stiffness, double tissue_damping,
                                      bool& finite) {
    start(stiffness, tissue_damping, working_depth);
    const double load = stiffness * working_depth;
    double x = disturbance, v = 0;  // from equilibrium, where the hand's spring is at rest
    double early = 0, late = 0;
    for (int tick = 0; tick < run_ticks; ++tick) {
        const double f = load - force(working_depth + x);
        const double next = law.a11 * x + law.a12 * v + law.g1 * f;
        v = law.a21 * x + law.a22 * v + law.g2 * f;
        x = next;
        if (!std::isfinite(x) || !std::isfinite(v)) {
            finite = false;
            return false;
        }
        if (std::abs(x) > working_depth) return false;  // thrown out of the contact
        if (tick >= settle_ticks && tick < 2 * settle_ticks) early = std::max(early, std::abs(x));
        if (tick >= run_ticks - settle_ticks) late = std::max(late, std::abs(x));
    }
    // An oscillation of a few encoder steps comes from the encoder, not from the loop.
    return late < early || late < 4 * device.encoder_step;
}

// A hand that moves the device back and forth regardless of the force: energy returned to it over whole
// periods, beyond the dissipation of the device's damping. After whole periods every energy store is
// unchanged.
double DeviceAtContact::Parts::energy_of(double stiffness, double tissue_damping, double frequency,
                                         double amplitude) {
    start(stiffness, tissue_damping, working_depth);
    constexpr int from = 200, to = 600;  // ticks; 0.4 s are whole periods of any multiple of 2.5 Hz
    const double turn = 2 * pi * frequency * device.period;
    PassivityObserver observer;
    double lost = 0;
    double cosine = 1, sine = 0;
    for (int tick = 0; tick < to; ++tick) {
        const double before = amplitude * cosine;
        math::sin_cos(turn * (tick + 1), sine, cosine);
        // Linear from one sample to the next: no other motion through the same samples loses less to the
        // device's damping.
        const double speed = (amplitude * cosine - before) / device.period;
        const double f = force(working_depth + before);
        if (tick < from) continue;
        observer.step(Vector3(0, 0, f), Vector3(0, 0, -speed), device.period);
        lost += device.damping * speed * speed * device.period;
    }
    return observer.given - lost;
}

double DeviceAtContact::returned_energy(double stiffness, double damping) {
    double most = -1e30;
    const double nyquist = 0.5 / parts_->device.period;
    for (const double share : {0.01, 0.1, 0.3, 0.6, 0.85, 1.0}) {
        most = std::max(most, parts_->energy_of(stiffness, damping, share * nyquist, disturbance));
    }
    return most;
}

DeviceRun DeviceAtContact::run(double stiffness, double damping, bool worst_hand) {
    DeviceRun run;
    const SimulatedDevice& device = parts_->device;
    const double nyquist = pi / device.period;
    run.stable = true;
    for (const double share : {0.0, 0.3, 0.6, 0.85, 0.95, 0.99}) {
        if (share > 0 && !worst_hand) break;
        const double spring = device.mass * share * share * nyquist * nyquist;
        const MotionLaw law(device.mass, device.damping, spring, device.period);
        run.stable = parts_->dies_out(law, stiffness, damping, run.finite) && run.stable;
        if (share <= 0) run.stiffness = parts_->state.stiffness;
    }
    run.returned = returned_energy(stiffness, damping);
    run.passive = run.returned <= 1e-3 * 0.5 * stiffness * disturbance * disturbance;
    return run;
}

double DeviceAtContact::boundary(double damping, double relative) {
    double low = 1, high = 1e5;
    const MotionLaw law(parts_->device.mass, parts_->device.damping, 0, parts_->device.period);
    while (high / low > 1 + relative) {
        const double middle = std::sqrt(low * high);
        bool finite = true;
        (parts_->dies_out(law, middle, damping, finite) ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

std::vector<StabilityMap> haptic_stability_maps() {
    const SimulatedDevice device;
    StabilityAxis stiffness, damping;
    stiffness.name = "stiffness_n_m";
    stiffness.unit = "N/m";
    for (double k = 100; k < 6500; k *= 1.25) stiffness.values.push_back(std::round(k));
    damping.name = "damping_n_s_m";
    damping.unit = "N s/m";
    damping.values = {0, 0.1, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0};
    damping.logarithmic = false;
    StabilityCurve stable, passive;
    stable.name = "stability: K (T/2 + t_d) = b + B";
    stable.formula = "docs/THEORY.md, section 6: a device alone, small B T / m";
    passive.name = "passivity: K = 2 (b - |B|) / T";
    passive.formula = "Eq. 8 with Colgate's |B|: sufficient with any passive hand";
    for (double b = 0; b <= 1.0001; b += 0.05) {
        stable.x.push_back(
            stable_stiffness(b, device.damping, device.period, device.delay_ticks * device.period));
        stable.y.push_back(b);
        if (b > device.damping) continue;
        passive.x.push_back(passive_stiffness(b, device.damping, device.period));
        passive.y.push_back(b);
    }
    std::vector<StabilityMap> maps;
    for (const FilterMode grade : {FilterMode::grade_0, FilterMode::grade_1, FilterMode::grade_2}) {
        DeviceAtContact contact(grade, device);
        const std::string name =
            "filter grade " + std::to_string(static_cast<int>(grade) - static_cast<int>(FilterMode::grade_0));
        for (const bool hand : {false, true}) {
            StabilityMap map;
            map.model = "haptics";
            map.title = name + (hand ? ", with the worst passive hand" : ", device alone");
            map.axes = {stiffness, damping};
            map.theory = {stable, passive};
            map.theory_note =
                "Device of 0.1 kg and 0.5 N s/m, 1 kHz, no delay, encoder step 0.1 um. Degraded: bounded, "
                "but a hand that "
                "moves it can draw energy from it.";
            map.measure = "J that a hand moving it by 0.3 mm draws from it in 0.4 s; below 0: gives";
            for (const double k : stiffness.values) {
                for (const double b : damping.values) {
                    const DeviceRun run = contact.run(k, b, hand);
                    StabilityCell cell;
                    cell.at = {k, b};
                    cell.finite = run.finite;
                    cell.measure = run.returned;
                    cell.outcome = !run.stable   ? StabilityOutcome::fault
                                   : run.passive ? StabilityOutcome::stable
                                                 : StabilityOutcome::degraded;
                    map.cells.push_back(cell);
                }
            }
            maps.push_back(std::move(map));
        }
    }
    return maps;
}

}  // namespace fulcrum::lab
