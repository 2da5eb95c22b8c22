// SPDX-License-Identifier: GPL-3.0-or-later
// Time from what happens in a tick to what a person without a device that renders force sees, hears and feels
// of it, in an attempt of the window: pale and dented tissue in a picture, the sounds of contact, too much
// force, energy and bleeding in a block of the sound device, the rumble of a controller. Sound device and
// controller are fakes of SDL 2. A few contacts each; FULCRUM_FEEDBACK_PAGE=docs/results takes twenty and
// writes the page.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>

#include "assessment/task/bowel_line.h"
#include "sim_core/lab/result_page.h"
#include "tests/app/prodding_rig.h"
#include "tests/app/window_fixture.h"
#include "tests/fakes/fake_page.h"
#include "tests/fakes/fake_sdl.h"
#include "tests/support/built.h"
#include "ui/style/text.h"

namespace fulcrum::app::program_test {
namespace {

using ui::window_test::wait_for;
using Leg = ProddingRig::Leg;
using Legs = std::vector<Leg>;

constexpr const char* feedback_page_variable = "FULCRUM_FEEDBACK_PAGE";
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr double sanitized = 20;  // times slower
#else
constexpr double sanitized = 1;
#endif
// ms, median.
constexpr double most_until_block = 100 * sanitized, most_until_rumble = 100 * sanitized,
                 most_until_picture = 150 * sanitized, most_of_one = 300 * sanitized;

/// What is heard at a time: the window plays the rest of its sounds as silence.
enum class HeardSound { contact, excess, energy, bleeding };
SoundState only(HeardSound kind, const SoundState& all) {
    SoundState one;
    one.volume = all.volume;
    for (int h = 0; h < hand_count; ++h) {
        if (kind == HeardSound::contact) one.contacts[h] = all.contacts[h];
        if (kind == HeardSound::contact) one.strength[h] = all.strength[h];
        if (kind == HeardSound::contact) one.hard[h] = all.hard[h];
        if (kind == HeardSound::excess) one.excess[h] = all.excess[h];
        if (kind == HeardSound::energy) one.energy[h] = all.energy[h];
    }
    if (kind == HeardSound::bleeding) one.bleeding = all.bleeding;
    return one;
}

double force_of(const HandSample& hand) {  // mN
    return std::hypot(std::hypot(hand.force[0], hand.force[1]), hand.force[2]);
}

/// The ticks of one prod, and when each output came, ns; 0: not waited for.
struct Prod {
    std::uint32_t from = 0, to = 0;
    std::int64_t heard = 0;  ///< of `sound`
    std::int64_t felt = 0, pale = 0, dented = 0;
    HeardSound sound = HeardSound::contact;
};
/// The tick of the event within a prod; 0: it has none.
using FindTick = std::function<std::uint32_t(const database::Trace&, const Prod&)>;

/// The first sample of a hand, within a prod, that fits.
FindTick first_sample(int hand, std::function<bool(const HandSample&)> fits) {
    return [hand, fits = std::move(fits)](const database::Trace& of, const Prod& prod) -> std::uint32_t {
        for (const TickSample& sample : of.samples)
            if (sample.tick >= prod.from && sample.tick <= prod.to && fits(sample.hand[hand]))
                return sample.tick;
        return 0;
    };
}

/// Before the services are made.
struct PadAndSound {
    PadAndSound() { page->controller[0].plugged = 1; }
    fulcrum::test::FakePage<fulcrum::test::FakeSdlPage> page{"FAKE_SDL_PAGE"};
    fulcrum::test::Variable library{"FULCRUM_LIBSDL2", fulcrum::test::fake_library("libSDL2.so")};
    fulcrum::test::Variable device{"FULCRUM_DEVICE", "controller"};
};

class FeedbackLatency : public PadAndSound, public Window {
  protected:
    void SetUp() override {
        services.hears = true;
        services.between = [this](std::shared_ptr<Rig> own) -> std::shared_ptr<Rig> {
            rig = std::make_shared<ProddingRig>(std::move(own));
            return rig;
        };
        create_programme_and_trainee();
    }
    /// How often, of `few` in the suite.
    static int times(int few) { return std::getenv(feedback_page_variable) != nullptr ? 20 : few; }
    void hear(HeardSound kind) {
        sound = kind;
        // A count of contacts that changed would be heard as one more.
        services.heard = [kind, begun = std::optional<SoundState>()](const SoundState& all) mutable {
            if (!begun) begun = all;
            SoundState one = only(kind, all);
            if (kind != HeardSound::contact)
                std::copy(std::begin(begun->contacts), std::end(begun->contacts), std::begin(one.contacts));
            return one;
        };
    }
    void begin(const char* task) {
        start(task, false);
        ASSERT_TRUE(wait_for([&] { return page->sound.plays == 1U; }));
    }
    const InstrumentSpec& spec(Hand hand) { return *theatre().session()->scene().instrument(hand); }
    /// Nothing of the prod before is seen, heard or felt any more.
    bool is_quiet() {
        const std::uint64_t played = page->sound.played, blocks = page->sound.blocks;
        wait_for([&] { return page->sound.blocks > blocks + 4; }, 1000);
        const ui::TheatreView& view = *theatre().view();
        return page->sound.played == played && !view.is_pale() && !view.is_dented() &&
               page->controller[0].slow == 0U && page->controller[0].fast == 0U;
    }
    static constexpr unsigned heard = 1, felt = 2, pale = 4, dented = 8;  // outputs
    /// Sends the tip of a hand along the legs; waits for these outputs.
    void prod(Hand hand, const Legs& legs, unsigned outputs) {
        ASSERT_TRUE(wait_for([&] { return is_quiet(); }, 20000));
        const ui::TheatreView& view = *theatre().view();
        const std::int64_t pale_before = view.pale_at(), dented_before = view.dented_at();
        page->sound.heard_at = 0;
        page->controller[0].felt_at = 0;
        Prod one;
        one.sound = sound;
        rig->send(spec(hand), legs);
        // The first of each: tissue may be let go of and touched again.
        const auto note = [](std::int64_t now, std::int64_t before, std::int64_t& first) {
            if (first == 0 && now != before) first = now;
        };
        ASSERT_TRUE(wait_for(
            [&] {
                if ((outputs & heard) != 0) note(page->sound.heard_at, 0, one.heard);
                if ((outputs & felt) != 0) note(page->controller[0].felt_at, 0, one.felt);
                if ((outputs & pale) != 0) note(view.pale_at(), pale_before, one.pale);
                if ((outputs & dented) != 0) note(view.dented_at(), dented_before, one.dented);
                const unsigned came = (one.heard != 0 ? heard : 0U) | (one.felt != 0 ? felt : 0U) |
                                      (one.pale != 0 ? pale : 0U) | (one.dented != 0 ? dented : 0U);
                return rig->finished() && came == outputs;
            },
            20000))
            << "outputs " << outputs << ": heard " << one.heard << ", felt " << one.felt << ", pale "
            << one.pale << ", dented " << one.dented;
        one.from = rig->begun();
        one.to = rig->ended();
        prods.push_back(one);
    }
    /// Without waiting for anything.
    void go(Hand hand, const Legs& legs) {
        rig->send(spec(hand), legs);
        ASSERT_TRUE(wait_for([&] { return rig->finished(); }, 20000));
    }
    void end() {
        abandon();
        trace = database::Attempts(*services.store())
                    .read_trace(window.context().session(), newest_attempt().meta.id);
    }
    /// After end(): ms from the event of each prod with this output, and with this sound, to the output.
    std::vector<double> delays(const FindTick& event, std::int64_t Prod::*output,
                               HeardSound of = HeardSound::contact) {
        std::vector<double> all;
        for (const Prod& one : prods) {
            if (one.*output == 0 || one.sound != of) continue;
            const std::uint32_t tick = event(trace, one);
            EXPECT_NE(tick, 0U) << "nothing happened between " << one.from << " and " << one.to;
            all.push_back(1e-6 * static_cast<double>(one.*output - rig->time_of(tick)));
            EXPECT_GT(all.back(), 0) << "tick " << tick << ": before it happened";
        }
        return all;
    }
    /// Expects a median (ms) and adds a row of the page.
    static void report(const char* event, const char* output, const char* task, std::vector<double> delays,
                       double most) {
        ASSERT_FALSE(delays.empty()) << event;
        std::sort(delays.begin(), delays.end());
        const double median = delays[delays.size() / 2];
        std::cout << event << ", " << output << ": " << delays.size() << " times, median " << median
                  << " ms, largest " << delays.back() << " ms\n";
        EXPECT_LT(median, most) << event << ", " << output;
        rows().push_back({event, output, task, std::to_string(delays.size()),
                          ui::plain(ui::decimal(median, 1)), ui::plain(ui::decimal(delays.back(), 1))});
        write();
    }
    static std::vector<std::vector<std::string>>& rows() {
        static std::vector<std::vector<std::string>> all;
        return all;
    }
    static void write();

    std::shared_ptr<ProddingRig> rig;  ///< of the attempt
    HeardSound sound = HeardSound::contact;
    std::vector<Prod> prods;
    database::Trace trace;
};

void FeedbackLatency::write() {
    const char* const folder = std::getenv(feedback_page_variable);
    if (folder == nullptr) return;
    lab::ResultPage page("feedback", "From a tick to what is seen, heard and felt without a force device",
                         std::string(feedback_page_variable) +
                             "=docs/results xvfb-run -a -s '-screen 0 1280x800x24 -noreset' test_app "
                             "--gtest_filter=FeedbackLatency.*");
    page.paragraph(
        "Attempts in the program's window at 1024 x 768 under Xvfb (drawn by the processor) with its own "
        "threads, world and recorder; nothing else was started. A hand presses again and again, or its pedal "
        "is "
        "pressed; the time begins where the tick was read whose record has the event (of bleeding: the last "
        "tick of the world step that opened the vessel). It ends where the first picture with it has been "
        "painted, where the first block of 256 frames that has a sample of it was handed to the sound "
        "device, "
        "or where the library was asked to run a motor. Controller and sound device are fakes of SDL 2: what "
        "a screen, a sound server or a motor adds is not in these times.");
    lab::ResultTable table;
    table.name = "feedback";
    table.columns = {"what happens", "output", "task", "times", "median, ms", "largest, ms"};
    table.rows = rows();
    page.table(table);
    page.write(folder, lab::this_machine(lab::build_info()));
}

/// m, from a place to the shaft between its trocar and a tip.
double to_shaft(const Vector3& place, const Vector3& trocar, const Vector3& tip) {
    const Vector3 shaft = tip - trocar;
    const double share = std::clamp((place - trocar).dot(shaft) / shaft.squaredNorm(), 0.0, 1.0);
    return (place - trocar - share * shaft).norm();
}

TEST_F(FeedbackLatency, OfContactAndTooMuchForceByPictureSoundAndRumble) {
    ASSERT_NO_FATAL_FAILURE(begin("A2"));
    const ui::AttemptSession& session = *theatre().session();
    const InstrumentSpec& left = spec(Hand::left);
    const Vector3 trocar = left.trocar.position;
    // The sphere that a shaft reaches farthest from all others.
    const std::vector<TargetSphere> targets = session.snapshot().targets;
    TargetSphere target;
    double clear = 0;
    for (const TargetSphere& one : targets) {
        double nearest = 1;
        for (const TargetSphere& other : targets)
            if (other.centre != one.centre)
                nearest = std::min(nearest, to_shaft(other.centre, trocar, one.centre));
        if (nearest > clear) target = one;
        clear = std::max(clear, nearest);
    }
    ASSERT_GT(clear, target.radius + left.tip_radius + 1e-3);
    const Vector3 out = (trocar - target.centre).normalized(),
                  surface = target.centre + (target.radius + left.tip_radius) * out,
                  away = surface + 0.015 * out;
    const double limit = session.scene().tissues[0].force_limit;
    ASSERT_GT(limit, 1);
    ASSERT_NO_FATAL_FAILURE(go(Hand::left, {{away, 800}}));
    const auto press = [&](double depth) -> Legs {
        const Vector3 in = surface - depth * out;
        return {{in, 150}, {in, 100}, {away, 150}};
    };
    hear(HeardSound::contact);
    for (int i = 0; i < times(3); ++i)
        ASSERT_NO_FATAL_FAILURE(prod(Hand::left, press(0.001), heard | felt | pale));
    hear(HeardSound::excess);
    for (int i = 0; i < times(3); ++i) ASSERT_NO_FATAL_FAILURE(prod(Hand::left, press(0.004), heard));
    ASSERT_NO_FATAL_FAILURE(end());
    const FindTick contact = first_sample(0, [](const HandSample& hand) { return force_of(hand) > 50; });
    const FindTick touch = first_sample(0, [](const HandSample& hand) { return force_of(hand) > 0; });
    const FindTick over =
        first_sample(0, [limit](const HandSample& hand) { return force_of(hand) > 1e3 * limit; });
    report("contact (0.05 N)", "click, in a block", "A2", delays(contact, &Prod::heard), most_until_block);
    report("contact (0.05 N)", "rumble of the controller", "A2", delays(contact, &Prod::felt),
           most_until_rumble);
    report("first force", "paler tissue, in a picture", "A2", delays(touch, &Prod::pale), most_until_picture);
    report("force above the limit", "tone, in a block", "A2", delays(over, &Prod::heard, HeardSound::excess),
           most_until_block);
}

TEST_F(FeedbackLatency, OfTheFirstForceOnBowelByADentInThePicture) {
    ASSERT_NO_FATAL_FAILURE(begin("B1"));
    const Scene& scene = theatre().session()->scene();
    const InstrumentSpec& left = spec(Hand::left);
    const int bowel = scene.tissue_index("bowel");
    ASSERT_GE(bowel, 0);
    double place = 0;  // m along the bowel
    struct Lines {
        Vector3 in, away;
    };
    // Where the bowel is now.
    const auto lines = [&] {
        const Vector3 middle = line_point(theatre().session()->snapshot(), place).position;
        const Vector3 out = (left.trocar.position - middle).normalized(),
                      surface = middle + (scene.bowel->outer_radius + left.tip_radius) * out;
        return Lines{surface - 0.008 * out, surface + 0.02 * out};
    };
    // A place above which neither tip nor shaft touches another loop.
    bool is_free = false;
    for (const double one : {0.26, 0.34, 0.52, 0.60}) {
        place = one;
        ASSERT_NO_FATAL_FAILURE(go(Hand::left, {{lines().away, 800}}));
        is_free = wait_for([&] { return is_quiet(); }, 2000);
        if (is_free) break;
    }
    ASSERT_TRUE(is_free);
    for (int i = 0; i < times(3); ++i) {
        ASSERT_NO_FATAL_FAILURE(go(Hand::left, {{lines().away, 100}}));
        const Lines now = lines();
        ASSERT_NO_FATAL_FAILURE(prod(Hand::left, {{now.in, 250}, {now.in, 150}, {now.away, 200}}, dented));
    }
    ASSERT_NO_FATAL_FAILURE(end());
    const FindTick touch = first_sample(
        0, [bowel](const HandSample& hand) { return hand.tissue == bowel && force_of(hand) > 0; });
    report("first force on bowel", "dent, in a picture", "B1", delays(touch, &Prod::dented),
           most_until_picture);
}

TEST_F(FeedbackLatency, OfEnergyByItsHum) {
    ASSERT_NO_FATAL_FAILURE(begin("B3"));
    const Vector3 tip = theatre().session()->snapshot().tools[1].tip;
    hear(HeardSound::energy);
    ASSERT_NO_FATAL_FAILURE(go(Hand::right, {{tip, 50}}));
    for (int i = 0; i < times(3); ++i)
        ASSERT_NO_FATAL_FAILURE(prod(Hand::right, {{tip, 20}, {tip, 200, true}, {tip, 50}}, heard));
    ASSERT_NO_FATAL_FAILURE(end());
    const FindTick pressed = [](const database::Trace& of, const Prod& one) -> std::uint32_t {
        for (const RigSample& input : of.inputs)
            if (input.tick >= one.from && input.tick <= one.to &&
                (input.hand[1].buttons & button_energy) != 0)
                return input.tick;
        return 0;
    };
    report("pedal pressed", "hum, in a block", "B3", delays(pressed, &Prod::heard, HeardSound::energy),
           most_until_block);
}

/// A blunt tip pressed on the fascia over the vein in the middle of C4, where it tears. The alarm does not
/// end before the attempt does.
TEST_F(FeedbackLatency, OfBleedingByItsAlarm) {
    std::vector<double> until_block;
    const int attempts = times(1);
    for (int attempt = 0; attempt < attempts; ++attempt) {
        hear(HeardSound::bleeding);
        ASSERT_NO_FATAL_FAILURE(begin("C4"));
        const auto& veins = theatre().session()->snapshot().structures.veins;
        ASSERT_FALSE(veins.empty());
        const std::vector<Vector3>& line = veins[0].line;
        ASSERT_GT(line.size(), 10U);
        const std::size_t i = 2 * line.size() / 5;
        const InstrumentSpec& left = spec(Hand::left);
        Vector3 out = (line[i + 1] - line[i - 1]).cross(Vector3::UnitX()).normalized();
        if (out.dot(left.trocar.position - line[i]) < 0) out = -out;
        constexpr double depth = 0.0085, aside = 0.005;  // m
        const Vector3 before = line[i] + 0.03 * out, in = line[i] + (left.tip_radius - depth) * out,
                      right = aside * Vector3::UnitX();
        ASSERT_NO_FATAL_FAILURE(
            prod(Hand::left,
                 {{before, 1200}, {in, 300}, {in + right, 150}, {in - right, 300}, {in, 150}, {before, 300}},
                 heard));
        ASSERT_NO_FATAL_FAILURE(end());
        const FindTick opened = [](const database::Trace& of, const Prod& one) -> std::uint32_t {
            for (const Event& event : of.events)
                if (event.kind == EventKind::bleed_begin && event.tick >= one.from && event.tick <= one.to)
                    return event.tick;
            return 0;
        };
        for (const double delay : delays(opened, &Prod::heard, HeardSound::bleeding))
            until_block.push_back(delay);
        prods.clear();
        home();
    }
    report("bleeding (above 10 mL/min)", "alarm, in a block", "C4", until_block,
           attempts == 1 ? most_of_one : most_until_block);
}

}  // namespace
}  // namespace fulcrum::app::program_test
