// SPDX-License-Identifier: Apache-2.0
// A measured page for people and programs: Markdown, JSON, CSV tables, SVG charts, with machine and commit.
// Written by commands, never by hand.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "sim_core/lab/machine.h"

namespace fulcrum::lab {

struct ResultTable {
    std::string name;  ///< file NAME.csv; empty: in the page alone
    std::vector<std::string> columns;
    std::vector<std::vector<std::string>> rows;
};

struct ResultFile {
    std::string name;  ///< with its extension
    std::string bytes;
};

class ResultPage {
  public:
    /// id: file name without extension; command: what makes the page again.
    ResultPage(std::string id, std::string title, std::string command);

    void heading(const std::string& text);
    void paragraph(const std::string& text);
    /// In the page; also as CSV where it has a name.
    void table(const ResultTable& table);
    /// As CSV alone.
    void table_file(const ResultTable& table);
    /// SVG text as file NAME.svg, shown in the page.
    void chart(const std::string& name, const std::string& alternative, const std::string& svg);
    /// Any other file beside the page; images are shown.
    void file(const ResultFile& file, const std::string& alternative);
    /// The document of docs/FORMATS.md; written as ID.json with the machine added.
    void document(nlohmann::json json) { json_ = std::move(json); }
    const nlohmann::json& document() const { return json_; }

    /// Writes everything into a folder (made when missing). Returns the paths. Throws InputError when it
    /// cannot.
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
