// SPDX-License-Identifier: Apache-2.0
// A page of measurements for people and programs: Markdown, JSON, CSV tables, SVG charts, with machine and
// commit. Always written by a command.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim_core/lab/machine.h"

namespace fulcrum::lab {

struct ResultTable {
    std::string name;  ///< file NAME.csv; empty: in the page only
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

struct ResultFile {
    std::string name;  ///< with its extension
    std::string bytes;
};

class ResultPage {
  public:
    /// id: file name without extension; command: the command that generates the page.
    ResultPage(std::string id, std::string title, std::string command);

    void heading(const std::string& text);
    void paragraph(const std::string& text);
    /// Adds a table to the page; also as CSV if it has a name.
    void table(const ResultTable& table);
    /// Adds a table as CSV only.
    void table_file(const ResultTable& table);
    /// SVG text as file NAME.svg, shown in the page.
    void chart(const std::string& name, const std::string& alternative, const std::string& svg);
    /// Adds any other file next to the page; images are shown in it.
    void file(const ResultFile& file, const std::string& alternative);
    /// The document of docs/FORMATS.md; written as ID.json with the machine added.
    void document(nlohmann::json json) { json_ = std::move(json); }
    const nlohmann::json& document() const { return json_; }

    /// Writes everything into a folder (created if missing). Returns the paths. Throws InputError if a file
    /// cannot be written.
    std::vector<std::string> write(const std::string& folder, const Machine& machine) const;
    /// The page itself, Markdown.
    std::string text(const Machine& machine) const;
    const std::string& id() const { return id_; }

  private:
    std::string id_, title_, command_, body_;
    nlohmann::json json_;
    std::vector<ResultFile> files_;
};

}  // namespace fulcrum::lab
