// SPDX-License-Identifier: Apache-2.0
#include "sim_core/lab/result_page.h"

#include <filesystem>

#include "sim_core/numerics/files.h"

namespace fulcrum::lab {
namespace {

std::string in_markdown(const std::string& cell) {
    std::string result;
    for (const char c : cell) {
        if (c == '|')
            result += "\\|";
        else
            result += c == '\n' ? ' ' : c;
    }
    return result;
}

std::string in_csv(const std::string& cell) {
    if (cell.find_first_of(",\"\n\r") == std::string::npos) return cell;
    std::string result = "\"";
    for (const char c : cell) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + "\"";
}

bool ends_with(const std::string& text, const std::string& end) {
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

ResultPage::ResultPage(std::string id, std::string title, std::string command)
    : id_(std::move(id)), title_(std::move(title)), command_(std::move(command)) {}

void ResultPage::heading(const std::string& text) {
    body_ += "## " + text + "\n\n";
}

void ResultPage::paragraph(const std::string& text) {
    body_ += text + "\n\n";
}

void ResultPage::table(const ResultTable& table) {
    std::string rule;
    body_ += "|";
    for (const std::string& column : table.columns) {
        body_ += " " + in_markdown(column) + " |";
        rule += " --- |";
    }
    body_ += "\n|" + rule + "\n";
    for (const auto& row : table.rows) {
        body_ += "|";
        for (const std::string& cell : row) body_ += " " + in_markdown(cell) + " |";
        body_ += "\n";
    }
    body_ += "\n";
    if (!table.name.empty()) table_file(table);
}

void ResultPage::table_file(const ResultTable& table) {
    std::string csv;
    const auto line = [&](const std::vector<std::string>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) csv += (i > 0 ? "," : "") + in_csv(cells[i]);
        csv += "\n";
    };
    line(table.columns);
    for (const auto& row : table.rows) line(row);
    files_.push_back({table.name + ".csv", csv});
}

void ResultPage::chart(const std::string& name, const std::string& alternative, const std::string& svg) {
    file({name + ".svg", svg}, alternative);
}

void ResultPage::file(const ResultFile& file, const std::string& alternative) {
    files_.push_back(file);
    if (ends_with(file.name, ".svg") || ends_with(file.name, ".png"))
        body_ += "![" + alternative + "](" + file.name + ")\n\n";
}

std::string ResultPage::text(const Machine& machine) const {
    std::string text = "<!-- SPDX-License-Identifier: Apache-2.0 -->\n# " + title_ + "\n\nMade by `" +
                       command_ + "` at commit " + machine.build.commit + ", on " + machine.text() +
                       ". The command also writes these results as JSON and CSV; the repository keeps only "
                       "what people read.\n\n" +
                       body_;
    text.pop_back();
    return text;
}

std::vector<std::string> ResultPage::write(const std::string& folder, const Machine& machine) const {
    std::error_code failed;
    std::filesystem::create_directories(folder, failed);
    std::vector<std::string> paths;
    const auto put = [&](const std::string& name, const std::string& bytes) {
        const std::string path = (std::filesystem::path(folder) / name).string();
        write_whole_file(path, bytes);
        paths.push_back(path);
    };
    put(id_ + ".md", text(machine));
    nlohmann::json json = json_;
    json["$comment"] = "SPDX-License-Identifier: Apache-2.0";  // sorts first
    json["machine"] = to_json(machine);
    put(id_ + ".json", json.dump(1) + "\n");
    for (const ResultFile& file : files_) put(file.name, file.bytes);
    return paths;
}

}  // namespace fulcrum::lab
