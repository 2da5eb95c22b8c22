// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/scoring/external_import.h"

#include <algorithm>
#include <filesystem>
#include <istream>
#include <sstream>
#include <streambuf>

#include "assessment/assets/assets.h"
#include "assessment/metrics/metrics_json.h"
#include "assessment/metrics/version.h"
#include "assessment/trace/trace_csv.h"
#include "assessment/trace/trace_mapping.h"
#include "database/rows/crypto.h"
#include "database/scoring/scoring.h"
#include "sim_core/numerics/input_error.h"
#include "sim_core/scene/json_document.h"

namespace fulcrum {
namespace {

constexpr std::size_t import_limit_bytes = std::size_t{1} << 30U;
constexpr double reading_share = 0.8;  // of the progress; the rest is measuring

/// A text as a stream that reports how much of it was read. A stop ends it as the end of the file does.
class ReportingBuffer : public std::streambuf {
  public:
    ReportingBuffer(const std::string& text, const std::function<bool(double)>& progress)
        : text_(text), progress_(progress) {}
    bool stopped() const { return stopped_; }

  protected:
    int_type underflow() override {
        constexpr std::size_t stretch = std::size_t{1} << 20U;
        if (stopped_ || place_ == text_.size()) return traits_type::eof();
        if (progress_ &&
            !progress_(reading_share * static_cast<double>(place_) / static_cast<double>(text_.size()))) {
            stopped_ = true;
            return traits_type::eof();
        }
        const std::size_t size = std::min(stretch, text_.size() - place_);
        char* begin = const_cast<char*>(text_.data()) + place_;  // read only
        setg(begin, begin, begin + size);
        place_ += size;
        return traits_type::to_int_type(*gptr());
    }

  private:
    const std::string& text_;
    const std::function<bool(double)>& progress_;
    std::size_t place_ = 0;
    bool stopped_ = false;
};

void read_trace(std::istream& in, const std::string& path, const std::string& mapping_path,
                ExternalTrace& read, std::vector<MappedColumn>& mapped_columns) {
    if (mapping_path.empty()) {
        read.trace = read_trace_csv(in, path);
        return;
    }
    const std::string text = read_text_file(mapping_path, JsonLimits().bytes);
    const TraceMapping mapping = parse_trace_mapping(text, mapping_path);
    MappedTrace mapped = read_mapped_trace(in, path, mapping);
    read.trace = std::move(mapped.trace);
    read.left_out = mapped.left_out;
    read.source = mapping.title;
    read.files.push_back({database::external_mapping_file, database::sha256_hex(text)});
    mapped_columns = mapping.columns;
}

std::vector<std::string> cells_of(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream in(line);
    for (std::string cell; std::getline(in, cell, ',');) cells.push_back(cell);
    return cells;
}

/// The stored text begins with our names and units.
std::vector<ReadColumn> columns_of(const std::string& text, const std::vector<MappedColumn>& mapped) {
    std::istringstream in(text);
    std::string names, units;
    std::getline(in, names);
    std::getline(in, units);
    const std::vector<std::string> name = cells_of(names), unit = cells_of(units);
    std::vector<ReadColumn> columns;
    for (std::size_t i = 0; i < name.size() && i < unit.size(); ++i) {
        if (name[i] == "t") continue;
        ReadColumn column{name[i], unit[i], name[i], unit[i]};
        for (const MappedColumn& one : mapped)
            if (one.name == name[i]) {
                column.theirs = one.number > 0 ? std::to_string(one.number) : one.column;
                column.their_unit = one.unit;
            }
        if (mapped.empty() || std::any_of(mapped.begin(), mapped.end(),
                                          [&](const MappedColumn& one) { return one.name == name[i]; }))
            columns.push_back(std::move(column));
    }
    return columns;
}

/// Of the samples that follow one another without a gap.
double mean_rate(const Trace& trace) {
    double seconds = 0;
    std::size_t steps = 0;
    for (const TraceBlock& block : trace.blocks) {
        if (block.last - block.first < 2) continue;
        seconds += trace.t[block.last - 1] - trace.t[block.first];
        steps += block.last - block.first - 1;
    }
    return seconds > 0 ? static_cast<double>(steps) / seconds : 0;
}

}  // namespace

ExternalTrace read_external_trace(const std::string& path, const std::string& mapping,
                                  const std::function<bool(double)>& progress) {
    const auto go_on = [&](double share) {
        if (progress && !progress(share)) throw ReadingStopped();
    };
    ExternalTrace read;
    std::vector<MappedColumn> mapped;
    {
        const std::string text = read_text_file(path, import_limit_bytes);
        read.files.push_back({database::external_trace_file, database::sha256_hex(text)});
        ReportingBuffer buffer(text, progress);
        std::istream in(&buffer);
        try {
            read_trace(in, path, mapping, read, mapped);
        } catch (const InputError&) {
            if (!buffer.stopped()) throw;
        }
        if (buffer.stopped()) throw ReadingStopped();
    }
    go_on(reading_share);
    read.document = metrics_of_trace(read.trace, path);
    read.document["samples_left_out"] = read.left_out;
    for (const nlohmann::json& row : read.document["metrics"])
        read.measured += row["value"].is_null() ? 0 : 1;
    read.rate_hz = mean_rate(read.trace);
    std::ostringstream text;
    write_trace_csv(read.trace, text);
    read.text = text.str();
    read.columns = columns_of(read.text, mapped);
    go_on(1);
    return read;
}

database::ExternalAttempt external_attempt(const ExternalTrace& read) {
    database::ExternalAttempt attempt;
    attempt.source = read.source.empty() ? "trace file" : read.source;
    // A record of practice from a moment begins at that moment.
    attempt.duration_s = read.trace.t.back() - read.trace.t.front();
    attempt.files = read.files;
    attempt.program_version = program_version;
    attempt.trace = read.text;
    ScoredAttempt scored;
    scored.metrics = metrics_from_json(read.document["metrics"], "metrics");
    scored.score.not_scored_because = StatementId::recorded_elsewhere;
    attempt.score = to_row(scored, {});
    return attempt;
}

std::vector<DeliveredMapping> delivered_mappings() {
    std::vector<DeliveredMapping> mappings;
    for (const auto& entry : std::filesystem::directory_iterator(asset_path("mappings"))) {
        if (entry.path().extension() != ".json") continue;
        const std::string path = entry.path().string();
        mappings.push_back({path, load_trace_mapping(path).title});
    }
    std::sort(mappings.begin(), mappings.end(),
              [](const DeliveredMapping& a, const DeliveredMapping& b) { return a.title < b.title; });
    return mappings;
}

}  // namespace fulcrum
