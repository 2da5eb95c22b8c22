// SPDX-License-Identifier: Apache-2.0
#include "assessment/trace/events_csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <ostream>

#include "assessment/trace/csv_reader.h"
#include "sim_core/numerics/files.h"
#include "sim_core/telemetry/event_types.h"

namespace fulcrum {

namespace {

constexpr const char* column_names[] = {"t", "event", "hand", "tissue", "value", "detail"};
constexpr const char* column_units[] = {"s", "-", "-", "-", "event", "event"};
constexpr std::size_t column_count = std::size(column_names);

template <typename Number>
std::string decimal(Number number) {
    char text[40];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

void require_row(CsvReader& reader, std::size_t row, const char* const (&expected)[column_count],
                 const char* what) {
    if (!reader.next())
        reader.fail_at(
            row, "t", {QT_TRANSLATE_NOOP("errors", "the row of %1 is missing"), what},
            QT_TRANSLATE_NOOP("errors", "write t,event,hand,tissue,value,detail, then s,-,-,-,event,event"));
    std::vector<std::string_view> cells = reader.cells();
    if (row == 1 && cells[0].substr(0, 3) == "\xEF\xBB\xBF") cells[0].remove_prefix(3);
    if (!std::equal(cells.begin(), cells.end(), std::begin(expected), std::end(expected)))
        reader.fail(
            "(row)", {QT_TRANSLATE_NOOP("errors", "these are not the %1 of an events file"), what},
            QT_TRANSLATE_NOOP("errors", "write t,event,hand,tissue,value,detail, then s,-,-,-,event,event"));
}

template <typename Number>
Number number_in(const CsvReader& reader, std::size_t column, double low, double high) {
    const std::string_view cell = reader.cells()[column];
    Number value{};
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size())
        reader.fail(column_names[column],
                    {QT_TRANSLATE_NOOP("errors", "%1 is not a number"), CsvReader::quoted(cell)},
                    column == 5 ? Sentence(QT_TRANSLATE_NOOP("errors", "write a whole number"))
                                : Sentence(QT_TRANSLATE_NOOP("errors", "write a number")));
    const auto wide = static_cast<double>(value);
    if (!(wide >= low && wide <= high))
        reader.fail(
            column_names[column],
            {QT_TRANSLATE_NOOP("errors", "%1 is out of range"), CsvReader::quoted(cell)},
            {QT_TRANSLATE_NOOP("errors", "write a number from %1 to %2"), decimal(low), decimal(high)});
    return value;
}

std::uint8_t hand_in(const CsvReader& reader) {
    const std::string_view cell = reader.cells()[2];
    if (cell.empty()) return 255;
    for (int hand = 0; hand < hand_count; ++hand)
        if (cell == hand_name(static_cast<Hand>(hand))) return static_cast<std::uint8_t>(hand);
    reader.fail("hand", {QT_TRANSLATE_NOOP("errors", "%1 is not a hand"), CsvReader::quoted(cell)},
                QT_TRANSLATE_NOOP("errors", "write left, right or nothing"));
}

std::int8_t tissue_in(const CsvReader& reader, const std::vector<std::string>& tissues) {
    const std::string_view cell = reader.cells()[3];
    if (cell.empty()) return -1;
    const auto found = std::find(tissues.begin(), tissues.end(), cell);
    if (found == tissues.end())
        reader.fail(
            "tissue",
            {QT_TRANSLATE_NOOP("errors", "%1 is not a tissue of this task"), CsvReader::quoted(cell)},
            QT_TRANSLATE_NOOP("errors", "write a label of the task's scene or of the trace, or nothing"));
    return static_cast<std::int8_t>(found - tissues.begin());
}

EventKind kind_in(const CsvReader& reader) {
    const std::string_view cell = reader.cells()[1];
    if (const auto* row = find_row(event_kinds, cell)) return row->kind;
    reader.fail("event", {QT_TRANSLATE_NOOP("errors", "%1 is not an event"), CsvReader::quoted(cell)},
                QT_TRANSLATE_NOOP("errors", "write a name from docs/FORMATS.md, such as grasp"));
}

}  // namespace

void put_seed(Event& event, std::uint64_t seed) {
    constexpr std::uint64_t largest = std::numeric_limits<std::int32_t>::max();
    if (event.kind == EventKind::attempt_begin && seed <= largest)
        event.detail = static_cast<std::int32_t>(seed);
}

void write_events_csv(std::vector<Event> events, const std::vector<std::string>& tissues, double tick_period,
                      std::ostream& out) {
    // The first movement is known only when it has lasted: it is recorded after later events.
    std::stable_sort(events.begin(), events.end(),
                     [](const Event& a, const Event& b) { return a.tick < b.tick; });
    out << "t,event,hand,tissue,value,detail\ns,-,-,-,event,event\n";
    for (const Event& event : events) {
        out << decimal(event.tick * tick_period) << ',' << event_name(event.kind) << ',';
        if (event.hand < hand_count) out << hand_name(static_cast<Hand>(event.hand));
        out << ',';
        if (event.tissue >= 0) out << tissues.at(static_cast<std::size_t>(event.tissue));
        out << ',' << decimal(event.value) << ',' << decimal(event.detail) << '\n';
    }
}

std::vector<Event> read_events_csv(std::istream& in, const std::string& file,
                                   const std::vector<std::string>& tissues, double tick_period) {
    CsvReader reader(in, file);
    require_row(reader, 1, column_names, QT_TRANSLATE_NOOP("errors", "names"));
    require_row(reader, 2, column_units, QT_TRANSLATE_NOOP("errors", "units"));
    std::vector<Event> events;
    while (reader.next()) {
        if (reader.cells().size() == 1 && reader.cells()[0].empty()) continue;  // blank lines at the end
        if (reader.cells().size() != column_count)
            reader.fail("(row)",
                        {QT_TRANSLATE_NOOP("errors", "%1 cells where there are %2"), reader.cells().size(),
                         column_count},
                        QT_TRANSLATE_NOOP("errors", "write t,event,hand,tissue,value,detail"));
        if (events.size() == events_csv_row_limit)
            reader.fail("(row)", {QT_TRANSLATE_NOOP("errors", "more than %1 events"), events_csv_row_limit},
                        QT_TRANSLATE_NOOP("errors", "give one attempt per file"));
        Event event;
        event.tick = static_cast<std::uint32_t>(
            std::llround(number_in<double>(reader, 0, 0.0, trace_csv_time_limit) / tick_period));
        event.kind = kind_in(reader);
        event.hand = hand_in(reader);
        event.tissue = tissue_in(reader, tissues);
        constexpr double most = std::numeric_limits<float>::max();
        event.value = number_in<float>(reader, 4, -most, most);
        event.detail = number_in<std::int32_t>(reader, 5, std::numeric_limits<std::int32_t>::min(),
                                               std::numeric_limits<std::int32_t>::max());
        if (!events.empty() && event.tick < events.back().tick)
            reader.fail("t", QT_TRANSLATE_NOOP("errors", "the time decreases"),
                        QT_TRANSLATE_NOOP("errors", "sort the rows by time"));
        events.push_back(event);
    }
    return events;
}

std::vector<Event> read_events_csv(const std::string& path, const std::vector<std::string>& tissues,
                                   double tick_period) {
    require_regular_file(path);
    std::ifstream in(path, std::ios::binary);
    if (!in)
        throw InputError(path, "", QT_TRANSLATE_NOOP("errors", "the file cannot be opened"),
                         QT_TRANSLATE_NOOP("errors", "check the path and its permissions"));
    return read_events_csv(in, path, tissues, tick_period);
}

}  // namespace fulcrum
