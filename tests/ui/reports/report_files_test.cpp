// SPDX-License-Identifier: GPL-3.0-or-later
// The files of reports: for the account alone that wrote them, in place of a link and never through it, and
// after a kill in the middle the old file or the new one, never a part.
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <QDir>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "assessment/assets/assets.h"
#include "tests/database/cut_off_process.h"
#include "tests/database/programme_fixture.h"
#include "ui/reports/report.h"

namespace fulcrum::ui {
namespace {

namespace files = std::filesystem;

constexpr const char* earlier_words = "what was here before\n";

/// A new file may be read and written by everybody.
class OpenToAll {
  public:
    OpenToAll() : before_(::umask(0)) {}
    ~OpenToAll() { ::umask(before_); }
    OpenToAll(const OpenToAll&) = delete;
    OpenToAll& operator=(const OpenToAll&) = delete;

  private:
    mode_t before_;
};

class FilesOfReports : public ::testing::Test {
  protected:
    FilesOfReports() { attempt = programme.record("ann"); }
    std::string in(const std::string& name) const {
        return programme.folder.filePath(QString::fromStdString(name)).toStdString();
    }
    static std::string read(const std::string& path) {
        std::ifstream file(path, std::ios::binary);
        std::ostringstream text;
        text << file.rdbuf();
        return text.str();
    }
    static void put(const std::string& path, const std::string& words) {
        std::ofstream(path, std::ios::binary) << words;
    }
    ReportRequest of_person(ReportFormat format, const std::string& path) const {
        ReportRequest request;
        request.person_id = programme.id("ann");
        request.format = format;
        request.path = path;
        request.home_page = "https://training.example";
        return request;
    }
    std::vector<std::string> write(const database::Store& store, const ReportRequest& request) const {
        return write_report(store, programme.session("director"), request, {load_task(task_file("A2"))},
                            "0.1.0");
    }
    /// Each file is a new one of this account; the file that links of these names pointed to is as it was.
    static void expect_private(const std::vector<std::string>& written, const std::string& target) {
        ASSERT_FALSE(written.empty());
        for (const std::string& path : written) {
            struct stat status {};
            ASSERT_EQ(::lstat(path.c_str(), &status), 0) << path;
            EXPECT_TRUE(S_ISREG(status.st_mode)) << path << " is still a link";
            EXPECT_EQ(status.st_mode & 0777U, 0600U) << path;
            EXPECT_GT(status.st_size, 0) << path;
        }
        EXPECT_EQ(read(target), earlier_words);
        struct stat status {};
        ASSERT_EQ(::stat(target.c_str(), &status), 0);
        EXPECT_EQ(status.st_mode & 0777U, 0666U) << target;
    }

    const database::test::TemporaryFoldersInMemory in_memory;
    database::test::Programme programme;
    std::string attempt;
};

TEST_F(FilesOfReports, OfEachFormatTakeThePlaceOfALinkAndAreTheirOwnersAlone) {
    const OpenToAll open_to_all;
    const std::string target = in("of somebody else");
    put(target, earlier_words);
    for (const ReportFormatRow& format : report_formats) {
        for (const char* subject : {"person", "cohort", "attempt"}) {
            const bool one_attempt = std::string(subject) == "attempt";
            if (one_attempt && (format.kind == ReportFormat::xlsx || format.kind == ReportFormat::xapi))
                continue;  // these have no report of one attempt
            ReportRequest request = of_person(format.kind, in(std::string(subject) + "." + format.name));
            if (std::string(subject) != "person") request.person_id.clear();
            if (std::string(subject) == "cohort") request.cohort_id = programme.cohort;
            if (one_attempt) request.attempt_id = attempt;
            // The dictionary of a CSV is next to it.
            for (const char* ending : {"", ".dictionary.csv"})
                files::create_symlink(target, request.path + ending);
            expect_private(write(*programme.store, request), target);
        }
    }
}

TEST_F(FilesOfReports, ThatAKillCutsOffAreTheOldOnesOrTheNewOnes) {
    if (!database::test::can_trace()) GTEST_SKIP() << "this machine forbids to trace a child";
    programme.store.reset();
    int kills = 0, kept = 0;
    for (const ReportFormat format : {ReportFormat::csv, ReportFormat::pdf}) {
        const ReportRequest request =
            of_person(format, in(std::string("ann.") + row_of(report_formats, format).name));
        const auto deed = [&] {
            const database::Store store = database::Store::open(programme.path, programme.clock.options());
            write(store, request);
        };
        const database::test::CutOff whole = database::test::cut_off(0, deed);
        ASSERT_EQ(whole.status, 0);
        const std::string complete = read(request.path);
        for (const int point : database::test::cut_off_points(whole.changes, 8)) {
            put(request.path, earlier_words);
            const database::test::CutOff cut = database::test::cut_off(point, deed);
            if (!cut.killed) continue;
            ++kills;
            const std::string found = read(request.path);
            kept += found == earlier_words ? 1 : 0;
            // A PDF has the second in which it was made.
            const bool is_new =
                format == ReportFormat::csv ? found == complete : found.size() + 16 > complete.size();
            EXPECT_TRUE(found == earlier_words || is_new)
                << "killed before change " << point << " (" << cut.call << "): " << found.substr(0, 200);
        }
        database::test::cut_off(0, deed);
        for (const auto& entry : files::directory_iterator(programme.folder.path().toStdString()))
            EXPECT_EQ(entry.path().string().find(".part-fulcrum-"), std::string::npos)
                << entry.path() << " was left";
    }
    EXPECT_GT(kept, 0);
    EXPECT_GT(kills, 0);
    std::printf("reports killed %d times: the old file was whole %d times\n", kills, kept);
}

}  // namespace
}  // namespace fulcrum::ui
