// SPDX-License-Identifier: Apache-2.0
#include "assessment/task/limit_source.h"

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>

namespace fulcrum {
namespace {

constexpr std::string_view set_mark = ", set ", experts_mark = " experts",
                           worst_mark = ", worst counted value", site_mark = ", taken over by ";

/// Takes `end` off the end of the text; false where it does not end with it.
bool take_end(std::string_view& text, std::string_view end) {
    if (text.size() < end.size() || text.substr(text.size() - end.size()) != end) return false;
    text.remove_suffix(end.size());
    return true;
}

/// Takes the number off the end of the text; none where it ends with no number.
std::optional<int> take_number(std::string_view& text) {
    std::size_t from = text.size();
    while (from > 0 && text[from - 1] >= '0' && text[from - 1] <= '9') --from;
    int number = 0;
    const char* const end = text.data() + text.size();
    const std::from_chars_result parsed = std::from_chars(text.data() + from, end, number);
    if (parsed.ec != std::errc() || parsed.ptr != end) return std::nullopt;
    text.remove_suffix(text.size() - from);
    return number;
}

std::optional<LimitSource> read_range(std::string_view line) {
    LimitSource source;
    source.kind = LimitSource::Kind::range;
    source.worst_counted = take_end(line, worst_mark);
    if (!take_end(line, experts_mark)) return std::nullopt;
    const std::optional<int> experts = take_number(line);
    if (!experts || !take_end(line, ", ")) return std::nullopt;
    const std::optional<int> set = take_number(line);
    if (!set || !take_end(line, set_mark)) return std::nullopt;
    source.of = std::string(line);
    source.set = *set;
    source.experts = *experts;
    return source;
}

std::optional<LimitSource> read_taken_over(std::string_view line) {
    LimitSource source;
    source.kind = LimitSource::Kind::taken_over;
    const std::optional<int> set = take_number(line);
    if (!set || !take_end(line, set_mark)) return std::nullopt;
    const std::size_t at = line.rfind(site_mark);
    if (at == std::string_view::npos) return std::nullopt;
    source.of = std::string(line.substr(0, at));
    source.site = std::string(line.substr(at + site_mark.size()));
    source.set = *set;
    return source;
}

}  // namespace

std::string limit_source_line(const LimitSource& source) {
    const std::string set = std::string(set_mark) + std::to_string(source.set);
    switch (source.kind) {
        case LimitSource::Kind::words:
            break;
        case LimitSource::Kind::range:
            return source.of + set + ", " + std::to_string(source.experts) + std::string(experts_mark) +
                   std::string(source.worst_counted ? worst_mark : std::string_view());
        case LimitSource::Kind::taken_over:
            return source.of + std::string(site_mark) + source.site + set;
    }
    return source.of;
}

LimitSource read_limit_source(const std::string& line) {
    if (const std::optional<LimitSource> range = read_range(line)) return *range;
    if (const std::optional<LimitSource> taken_over = read_taken_over(line)) return *taken_over;
    return {LimitSource::Kind::words, line};
}

}  // namespace fulcrum
