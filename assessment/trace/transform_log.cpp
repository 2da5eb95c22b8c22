// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/transform_log.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "assessment/trace/log_scanner.h"
#include "assessment/trace/utf8.h"

namespace fulcrum {
namespace {

constexpr std::int64_t second = 1000 * 1'000'000;   // ns
constexpr std::int64_t most_between = second / 10;  // of two poses between which one is interpolated
constexpr std::size_t device_limit = 64, name_limit = 120;

/// Entries of a pose: where the origin is, then the directions of the x, y and z axis.
constexpr std::size_t pose_entries = 12;
constexpr const char* entry_names[pose_entries] = {".x",        ".y",        ".z",        ".x_axis.x",
                                                   ".x_axis.y", ".x_axis.z", ".y_axis.x", ".y_axis.y",
                                                   ".y_axis.z", ".z_axis.x", ".z_axis.y", ".z_axis.z"};
/// Where they are in the 16 numbers of a transform.
constexpr std::size_t entry_places[pose_entries] = {3, 7, 11, 0, 4, 8, 1, 5, 9, 2, 6, 10};

struct TimedPose {
    std::int64_t time = 0;  // ns
    std::array<double, pose_entries> entries{};
};

struct RecordedDevice {
    std::string name;
    bool wanted = false;
    std::vector<TimedPose> poses;
};

struct WantedEntry {
    std::size_t device = 0, entry = 0;
};

/// Device and entry of a column's name.
std::optional<std::pair<std::string, std::size_t>> parts_of(const std::string& column) {
    std::optional<std::pair<std::string, std::size_t>> best;
    for (std::size_t e = 0; e < pose_entries; ++e) {
        const std::string end = entry_names[e];
        if (column.size() <= end.size() || column.compare(column.size() - end.size(), end.size(), end) != 0)
            continue;
        if (!best || end.size() > std::string(entry_names[best->second]).size())
            best = {column.substr(0, column.size() - end.size()), e};
    }
    return best;
}

template <typename Number>
Number number_of(const LogScanner& scanner, const std::string& text, const char* attribute) {
    Number value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() ||
        !std::isfinite(static_cast<double>(value)))
        scanner.fail({QT_TRANSLATE_NOOP("errors", "%1 is not a number: \"%2\""), std::string(attribute),
                      is_utf8(text) ? text.substr(0, name_limit) : std::string("?")},
                     QT_TRANSLATE_NOOP("errors", "remove this element, or record again"));
    return value;
}

std::int64_t time_of(const LogScanner& scanner, const LogElement& element) {
    const auto whole =
        number_of<std::int64_t>(scanner, scanner.attribute(element, "TimeStampSec"), "TimeStampSec");
    const auto part =
        number_of<std::int64_t>(scanner, scanner.attribute(element, "TimeStampNSec"), "TimeStampNSec");
    if (whole < -1 || whole > INT64_MAX / second - 1 || part < -second || part > second)
        scanner.fail(QT_TRANSLATE_NOOP("errors", "the time is out of range"),
                     QT_TRANSLATE_NOOP("errors", "remove this element, or record again"));
    return whole * second + part;
}

std::array<double, pose_entries> pose_of(const LogScanner& scanner, const std::string& text) {
    std::array<double, 16> numbers{};
    std::size_t count = 0, place = 0;
    constexpr const char* space = " \t\r\n,";
    for (place = text.find_first_not_of(space); place != std::string::npos;
         place = text.find_first_not_of(space, place)) {
        const std::size_t end = std::min(text.find_first_of(space, place), text.size());
        if (count < numbers.size())
            numbers[count] = number_of<double>(scanner, text.substr(place, end - place), "transform");
        ++count;
        place = end;
    }
    constexpr std::size_t last_row = 12;
    const bool rigid = count == numbers.size() && numbers[last_row] == 0 && numbers[last_row + 1] == 0 &&
                       numbers[last_row + 2] == 0 && numbers[last_row + 3] == 1;
    if (!rigid)
        scanner.fail(
            {QT_TRANSLATE_NOOP("errors",
                               "transform has not 16 numbers by rows, the last four of "
                               "them 0 0 0 1 (numbers: %1)"),
             count},
            QT_TRANSLATE_NOOP("errors", "choose a recording of rigid tools that PerkTutor stored as XML"));
    std::array<double, pose_entries> entries{};
    for (std::size_t e = 0; e < pose_entries; ++e) entries[e] = numbers[entry_places[e]];
    return entries;
}

class TransformLog {
  public:
    TransformLog(std::string_view text, const std::string& file, const std::vector<std::string>& columns)
        : scanner_(text, file) {
        for (const std::string& column : columns) {
            const auto parts = parts_of(column);
            WantedEntry wanted;
            wanted.device = device(parts ? parts->first : column);
            wanted.entry = parts ? parts->second : 0;
            devices_[wanted.device].wanted = true;
            wanted_.push_back(wanted);
        }
    }
    TransformTable table() {
        read();
        std::size_t clock = devices_.size();
        for (std::size_t d = 0; d < devices_.size(); ++d) {
            if (!devices_[d].wanted) continue;
            require_poses(devices_[d]);
            in_order(devices_[d].poses);
            if (clock == devices_.size() || devices_[d].poses.size() < devices_[clock].poses.size())
                clock = d;
        }
        TransformTable table;
        table.text = "t";
        for (std::size_t c = 0; c < wanted_.size(); ++c) table.text += ",c" + std::to_string(c + 1);
        table.text += '\n';
        if (clock < devices_.size()) write_rows(clock, table);
        for (const RecordedDevice& one : devices_)
            if (!one.wanted) table.ignored.push_back(one.name);
        return table;
    }

  private:
    std::size_t device(const std::string& name) {
        for (std::size_t d = 0; d < devices_.size(); ++d)
            if (devices_[d].name == name) return d;
        if (devices_.size() == device_limit)
            scanner_.fail({QT_TRANSLATE_NOOP("errors", "more than %1 devices"), device_limit},
                          QT_TRANSLATE_NOOP("errors", "choose a recording that PerkTutor stored as XML"));
        devices_.push_back({name, false, {}});
        return devices_.size() - 1;
    }
    void read() {
        LogElement element;
        if (!scanner_.next(element) || element.name != "TransformRecorderLog")
            scanner_.fail(QT_TRANSLATE_NOOP("errors", "does not begin with <TransformRecorderLog>"),
                          QT_TRANSLATE_NOOP("errors", "choose a recording that PerkTutor stored as XML"));
        bool closed = false;
        std::size_t count = 0;
        while (!closed && scanner_.next(element)) {
            closed = element.closes && element.name == "TransformRecorderLog";
            if (element.name != "log" || element.closes || scanner_.attribute(element, "type") != "transform")
                continue;
            const std::string& name = scanner_.attribute(element, "DeviceName");
            if (name.empty() || name.size() > name_limit || !is_utf8(name))
                scanner_.fail(QT_TRANSLATE_NOOP("errors", "DeviceName is empty, too long or not UTF-8"),
                              QT_TRANSLATE_NOOP("errors", "name the device in 3D Slicer and record again"));
            const std::size_t d = device(name);
            if (!devices_[d].wanted) continue;
            if (++count > transform_pose_limit)
                scanner_.fail({QT_TRANSLATE_NOOP("errors", "more than %1 samples"), transform_pose_limit},
                              QT_TRANSLATE_NOOP("errors", "split the trace"));
            devices_[d].poses.push_back(
                {time_of(scanner_, element), pose_of(scanner_, scanner_.attribute(element, "transform"))});
        }
        if (!closed)
            scanner_.fail(QT_TRANSLATE_NOOP("errors", "the file ends without </TransformRecorderLog>"),
                          QT_TRANSLATE_NOOP("errors", "the recording was cut off: copy the file again"));
    }
    void require_poses(const RecordedDevice& wanted) const {
        if (!wanted.poses.empty()) return;
        std::string known;
        for (const RecordedDevice& one : devices_)
            if (&one != &wanted && (!one.wanted || !one.poses.empty()))
                known += (known.empty() ? "" : ", ") + one.name;
        scanner_.fail({QT_TRANSLATE_NOOP("errors", "there is no pose of the device %1"), wanted.name},
                      {QT_TRANSLATE_NOOP("errors", "name one of these in the mapping: %1"),
                       known.empty() ? std::string("-") : known});
    }
    /// The recorder does not sort; of two poses at one time the later one in the file counts.
    static void in_order(std::vector<TimedPose>& poses) {
        std::stable_sort(poses.begin(), poses.end(),
                         [](const TimedPose& a, const TimedPose& b) { return a.time < b.time; });
        std::vector<TimedPose> kept;
        for (const TimedPose& pose : poses) {
            if (!kept.empty() && kept.back().time == pose.time) kept.pop_back();
            kept.push_back(pose);
        }
        poses = std::move(kept);
    }
    void write_rows(std::size_t clock, TransformTable& table) const {
        const std::vector<TimedPose>& times = devices_[clock].poses;
        std::vector<std::size_t> next(devices_.size(), 0);  // first pose at or after the row's time
        std::vector<TimedPose> now(devices_.size());
        for (const TimedPose& row : times) {
            bool complete = true;
            for (std::size_t d = 0; d < devices_.size() && complete; ++d)
                if (devices_[d].wanted) complete = pose_at(devices_[d].poses, row.time, next[d], now[d]);
            if (!complete) {
                ++table.left_out;
                continue;
            }
            table.text += text_of(static_cast<double>(row.time - times.front().time) / second);
            for (const WantedEntry& wanted : wanted_)
                table.text += ',' + text_of(now[wanted.device].entries[wanted.entry]);
            table.text += '\n';
        }
    }
    static bool pose_at(const std::vector<TimedPose>& poses, std::int64_t time, std::size_t& next,
                        TimedPose& pose) {
        while (next < poses.size() && poses[next].time < time) ++next;
        if (next == poses.size()) return false;
        const TimedPose& after = poses[next];
        if (after.time == time) {
            pose = after;
            return true;
        }
        if (next == 0 || after.time - poses[next - 1].time > most_between) return false;
        const TimedPose& before = poses[next - 1];
        const double share =
            static_cast<double>(time - before.time) / static_cast<double>(after.time - before.time);
        for (std::size_t e = 0; e < pose_entries; ++e)
            pose.entries[e] = before.entries[e] + share * (after.entries[e] - before.entries[e]);
        for (std::size_t axis = 3; axis < pose_entries; axis += 3) {
            const double length =
                std::hypot(pose.entries[axis], pose.entries[axis + 1], pose.entries[axis + 2]);
            for (std::size_t i = axis; length > 0 && i < axis + 3; ++i) pose.entries[i] /= length;
        }
        return true;
    }
    static std::string text_of(double number) {
        char digits[32];
        const auto [end, error] = std::to_chars(std::begin(digits), std::end(digits), number);
        return {digits, end};
    }

    LogScanner scanner_;
    std::vector<RecordedDevice> devices_;
    std::vector<WantedEntry> wanted_;
};

}  // namespace

std::string device_of_column(const std::string& column) {
    const auto parts = parts_of(column);
    return parts ? parts->first : std::string();
}

TransformTable transform_table(std::string_view text, const std::string& file,
                               const std::vector<std::string>& columns) {
    return TransformLog(text, file, columns).table();
}

}  // namespace fulcrum
