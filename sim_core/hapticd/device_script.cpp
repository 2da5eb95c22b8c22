// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "sim_core/hapticd/virtual_device.h"
#include "sim_core/numerics/files.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/numerics/number_text.h"

namespace fulcrum::hapticd {
namespace {

using nlohmann::json;

constexpr double furthest = 1;  // m from the device's origin
constexpr std::size_t most_points = 2'000'000;
constexpr std::size_t longest_file = 256U << 20U;

std::string text_of(const std::string& path) {
    require_regular_file(path);
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!(text << file.rdbuf()))
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "cannot be read, or is empty"),
                         QT_TRANSLATE_NOOP("errors", "check the file"));
    if (text.str().size() > longest_file)
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "is larger than 256 MiB"),
                         QT_TRANSLATE_NOOP("errors", "use a shorter recording"));
    return text.str();
}

/// Reads one script; every error names file, place and what to do.
class ScriptReader {
  public:
    explicit ScriptReader(const std::string& path) : path_(path) {
        try {
            root_ = json::parse(text_of(path));
        } catch (const json::exception& error) {
            throw InputError(path, "", {QT_TRANSLATE_NOOP("errors", "is not JSON: %1"), error.what()},
                             QT_TRANSLATE_NOOP("errors", "correct the document"));
        }
    }

    DeviceScript read() {
        known(root_, "",
              {"format", "title", "rate", "force", "left", "right", "scope", "recording", "repeat", "faults",
               "workspace"});
        if (root_.value("format", json()) != json("fulcrum-device-script"))
            bad("/format", QT_TRANSLATE_NOOP("errors", "must be \"fulcrum-device-script\""),
                QT_TRANSLATE_NOOP("errors", "add it, or name another file"));
        DeviceScript script;
        script.facts.kind = "virtual";
        const json title = root_.value("title", json("virtual device"));
        if (!title.is_string() || title.get<std::string>().size() > 200)
            bad("/title", QT_TRANSLATE_NOOP("errors", "must be a short text"),
                QT_TRANSLATE_NOOP("errors", "give a text of at most 200 bytes"));
        script.facts.title = title.get<std::string>();
        script.facts.rate = number(root_, "", "rate", 1000, 100, 4000);
        const json repeat = root_.value("repeat", json(false));
        if (!repeat.is_boolean())
            bad("/repeat", QT_TRANSLATE_NOOP("errors", "must be true or false"),
                QT_TRANSLATE_NOOP("errors", "correct it"));
        if (root_.contains("recording")) read_recording(next_to_script(root_.at("recording")), script);
        for (int i = 0; i < device_slots; ++i) {
            if (root_.contains(device_slot_names[i])) read_slot(i, script);
            script.slots[i].path.repeat = repeat.get<bool>();
        }
        if (!script.facts.slot[0] && !script.facts.slot[1] && !script.facts.slot[2])
            bad("", QT_TRANSLATE_NOOP("errors", "has none of left, right, scope and recording"),
                QT_TRANSLATE_NOOP("errors", "give at least one"));
        read_force(script);
        read_faults(script);
        read_workspace(script);
        return script;
    }

  private:
    [[noreturn]] void bad(const std::string& place, const Sentence& what, const Sentence& hint) const {
        throw InputError(path_, place, what, hint);
    }
    void known(const json& object, const std::string& place, const std::vector<std::string>& keys) const {
        if (!object.is_object())
            bad(place, QT_TRANSLATE_NOOP("errors", "must be an object"),
                QT_TRANSLATE_NOOP("errors", "write { … }"));
        for (const auto& [key, value] : object.items()) {
            if (std::find(keys.begin(), keys.end(), key) == keys.end())
                bad(place + "/" + key, QT_TRANSLATE_NOOP("errors", "is not a key of a device script"),
                    QT_TRANSLATE_NOOP("errors", "remove it or correct its name"));
        }
    }
    double number(const json& object, const std::string& place, const std::string& key, double usual,
                  double low, double high) const {
        if (!object.contains(key)) return usual;
        const json& value = object.at(key);
        const double number = value.is_number() ? value.get<double>() : NAN;
        if (!(number >= low && number <= high))
            bad(place + "/" + key,
                {QT_TRANSLATE_NOOP("errors", "must be a number from %1 to %2"), plain_number(low),
                 plain_number(high)},
                QT_TRANSLATE_NOOP("errors", "correct the value"));
        return number;
    }
    static std::string plain_number(double value) { return json(value).dump(); }
    /// A file next to the script.
    std::string next_to_script(const json& name) const {
        if (!name.is_string())
            bad("/recording", QT_TRANSLATE_NOOP("errors", "must be the name of a file"),
                QT_TRANSLATE_NOOP("errors", "write the name as a text"));
        const auto file = name.get<std::string>();
        const std::size_t slash = path_.find_last_of('/');
        return file.rfind('/', 0) == 0 || slash == std::string::npos ? file
                                                                     : path_.substr(0, slash + 1) + file;
    }

    void read_slot(int slot, DeviceScript& script) const {
        const std::string place = std::string("/") + device_slot_names[slot];
        const json& object = root_.at(device_slot_names[slot]);
        known(object, place, {"path", "hand"});
        DeviceScript::Slot& made = script.slots[slot];
        if (object.contains("path")) {
            const json& points = object.at("path");
            if (!points.is_array() || points.empty() || points.size() > most_points)
                bad(place + "/path", QT_TRANSLATE_NOOP("errors", "must be a list with at least one point"),
                    QT_TRANSLATE_NOOP("errors", "write [{\"t\": 0, \"position\": [0, 0, 0]}]"));
            made.path.points.clear();
            for (std::size_t i = 0; i < points.size(); ++i)
                made.path.points.push_back(point(points[i], place + "/path/" + std::to_string(i), made.path));
        } else if (made.path.points.empty()) {
            bad(place + "/path", QT_TRANSLATE_NOOP("errors", "is missing"),
                QT_TRANSLATE_NOOP("errors", "give the points of the path"));
        }
        script.facts.slot[slot] = true;
        if (!object.contains("hand")) return;
        if (slot == scope_slot)
            bad(place + "/hand", QT_TRANSLATE_NOOP("errors", "is not for the scope"),
                QT_TRANSLATE_NOOP("errors", "remove it"));
        const std::string at = place + "/hand";
        const json& hand = object.at("hand");
        known(hand, at, {"mass", "damping", "arm_stiffness", "arm_damping"});
        HandProperties properties;
        properties.arm = true;
        properties.mass = number(hand, at, "mass", properties.mass, 0.01, 10);
        properties.damping = number(hand, at, "damping", properties.damping, 0, 100);
        properties.arm_stiffness = number(hand, at, "arm_stiffness", properties.arm_stiffness, 1, 5000);
        properties.arm_damping = number(hand, at, "arm_damping", properties.arm_damping, 0, 100);
        made.hand = properties;
    }

    PathPoint point(const json& from, const std::string& place, const ScriptedPath& before) const {
        known(from, place, {"t", "position", "roll", "jaw", "buttons"});
        PathPoint point;
        point.time = number(from, place, "t", NAN, 0, 1e6);
        if (std::isnan(point.time))
            bad(place + "/t", QT_TRANSLATE_NOOP("errors", "is missing"),
                QT_TRANSLATE_NOOP("errors", "give the time in seconds"));
        if (!before.points.empty() && point.time <= before.points.back().time)
            bad(place + "/t", QT_TRANSLATE_NOOP("errors", "must be later than the point before"),
                QT_TRANSLATE_NOOP("errors", "sort the points by time"));
        const json position = from.value("position", json::array({0, 0, 0}));
        if (!position.is_array() || position.size() != 3)
            bad(place + "/position", QT_TRANSLATE_NOOP("errors", "must be three numbers in metres"),
                QT_TRANSLATE_NOOP("errors", "write [x, y, z]"));
        for (int axis = 0; axis < 3; ++axis) {
            const json& value = position[static_cast<std::size_t>(axis)];
            const double metres = value.is_number() ? value.get<double>() : NAN;
            if (!(std::abs(metres) <= furthest))
                bad(place + "/position", QT_TRANSLATE_NOOP("errors", "must be within 1 m of the origin"),
                    QT_TRANSLATE_NOOP("errors", "give metres"));
            point.position[axis] = metres;
        }
        point.roll = number(from, place, "roll", 0, -100, 100);
        point.jaw = number(from, place, "jaw", 1, 0, 1);
        point.buttons = static_cast<std::uint32_t>(number(from, place, "buttons", 0, 0, 15));
        return point;
    }

    void read_force(DeviceScript& script) const {
        if (!root_.contains("force")) return;
        const json& force = root_.at("force");
        known(force, "/force", {"damping", "peak", "continuous", "stiffness", "torque"});
        ForceOutput output;
        output.damping = number(force, "/force", "damping", 0.5, 0, 100);
        output.peak = number(force, "/force", "peak", 3.3, 0.01, 20);
        output.continuous = number(force, "/force", "continuous", output.peak, 0.01, output.peak);
        output.stiffness = number(force, "/force", "stiffness", 1e9, 1, 1e9);
        output.torque = number(force, "/force", "torque", 0, 0, 5);
        for (int h = 0; h < 2; ++h) {
            if (script.facts.slot[h]) script.facts.force[h] = output;
        }
    }

    /// Without it 10 cm to each side of the origin.
    void read_workspace(DeviceScript& script) const {
        const json list = root_.value("workspace", json::array({-0.1, -0.1, -0.1, 0.1, 0.1, 0.1}));
        WorkspaceBox box;
        bool numbers = list.is_array() && list.size() == 6;
        for (std::size_t i = 0; numbers && i < 6; ++i) {
            numbers = list[i].is_number();
            if (numbers)
                (i < 3 ? box.least : box.most)[static_cast<Eigen::Index>(i % 3)] = list[i].get<double>();
        }
        if (!numbers || !is_usable(box))
            bad("/workspace", QT_TRANSLATE_NOOP("errors", "must be two corners of a box in metres"),
                QT_TRANSLATE_NOOP("errors", "write [-0.08, -0.06, -0.035, 0.08, 0.06, 0.035]"));
        for (int i = 0; i < device_slots; ++i) {
            if (!script.facts.slot[i]) continue;
            script.facts.workspace[i] = box;
            script.facts.clutch[i] = true;
        }
    }

    void read_faults(DeviceScript& script) const {
        const json faults = root_.value("faults", json::array());
        if (!faults.is_array())
            bad("/faults", QT_TRANSLATE_NOOP("errors", "must be a list"),
                QT_TRANSLATE_NOOP("errors", "write [ … ]"));
        for (std::size_t i = 0; i < faults.size(); ++i) {
            const std::string place = "/faults/" + std::to_string(i);
            known(faults[i], place, {"t", "for", "kind", "after_force"});
            ScriptedFault fault;
            fault.time = number(faults[i], place, "t", 0, 0, 1e6);
            fault.length = number(faults[i], place, "for", 0.1, 0.001, 1e6);
            const json after_force = faults[i].value("after_force", json(false));
            if (!after_force.is_boolean())
                bad(place + "/after_force", QT_TRANSLATE_NOOP("errors", "must be true or false"),
                    QT_TRANSLATE_NOOP("errors", "correct it"));
            fault.after_force = after_force.get<bool>();
            const json kind = faults[i].value("kind", json());
            if (kind == "silence")
                fault.kind = ScriptedFaultKind::silence;
            else if (kind == "not_a_number")
                fault.kind = ScriptedFaultKind::not_a_number;
            else if (kind == "jump")
                fault.kind = ScriptedFaultKind::jump;
            else
                bad(place + "/kind", QT_TRANSLATE_NOOP("errors", "is not a fault"),
                    QT_TRANSLATE_NOOP("errors", "use silence, not_a_number or jump"));
            script.faults.push_back(fault);
        }
    }

    std::string path_;
    json root_;
};

}  // namespace

void read_recording(const std::string& path, DeviceScript& script) {
    std::istringstream lines(text_of(path));
    std::string line;
    constexpr const char* header = "t,slot,x,y,z,roll,jaw,buttons";
    if (!std::getline(lines, line) || line != header)
        throw InputError(path, "1", {QT_TRANSLATE_NOOP("errors", "the first line must be %1"), header},
                         QT_TRANSLATE_NOOP("errors", "write this line first, as docs/DEVICES.md describes"));
    std::size_t row = 1;
    while (std::getline(lines, line)) {
        const std::string place = std::to_string(++row);
        std::vector<std::string> cells;
        std::istringstream cut(line);
        for (std::string cell; std::getline(cut, cell, ',');) cells.push_back(cell);
        if (cells.size() != 8)
            throw InputError(path, place, QT_TRANSLATE_NOOP("errors", "must have 8 columns"),
                             QT_TRANSLATE_NOOP("errors", "correct the row"));
        int slot = -1;
        for (int i = 0; i < device_slots; ++i) {
            if (cells[1] == device_slot_names[i]) slot = i;
        }
        if (slot < 0)
            throw InputError(path, place, {QT_TRANSLATE_NOOP("errors", "slot '%1' is not known"), cells[1]},
                             QT_TRANSLATE_NOOP("errors", "use left, right or scope"));
        double value[8] = {};
        for (const std::size_t i : {0U, 2U, 3U, 4U, 5U, 6U, 7U}) {
            const std::optional<double> number = parse_decimal(cells[i]);
            const double limit = i == 0 ? 1e6 : i == 7 ? 15 : i == 5 ? 1e4 : 1;
            if (!number || !(std::abs(*number) <= limit))
                throw InputError(path, place,
                                 {QT_TRANSLATE_NOOP("errors", "'%1' is not a usable number"), cells[i]},
                                 {QT_TRANSLATE_NOOP("errors", "correct column %1"), i + 1});
            value[i] = *number;
        }
        std::vector<PathPoint>& points = script.slots[slot].path.points;
        if (value[0] < 0 || (!points.empty() && value[0] <= points.back().time))
            throw InputError(path, place, QT_TRANSLATE_NOOP("errors", "times must increase from 0"),
                             QT_TRANSLATE_NOOP("errors", "sort the rows of each slot by time"));
        if (points.size() >= most_points)
            throw InputError(path, place, QT_TRANSLATE_NOOP("errors", "too many rows"),
                             QT_TRANSLATE_NOOP("errors", "use a shorter recording"));
        points.push_back({value[0], Vector3(value[2], value[3], value[4]), value[5], std::abs(value[6]),
                          static_cast<std::uint32_t>(std::abs(value[7]))});
        script.facts.slot[slot] = true;
    }
    if (row == 1)
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "has no readings"),
                         QT_TRANSLATE_NOOP("errors", "record again"));
}

DeviceScript read_device_script(const std::string& path) {
    return ScriptReader(path).read();
}

}  // namespace fulcrum::hapticd
