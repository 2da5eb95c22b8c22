// SPDX-License-Identifier: GPL-3.0-or-later
// An educator makes limits from the stored attempts of named experts: chooses what they are for and whose
// attempts they are made of, sees the limits, what was left out and who would pass, and puts the set in force
// or saves it as a file. Made by the function behind `fulcrum benchmark build`.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "database/scoring/expert_attempts.h"
#include "database/scoring/limit_trial.h"
#include "ui/page/context.h"

class QComboBox;
class QFrame;
class QLabel;
class QLineEdit;
class QPushButton;
class QTableWidget;

namespace fulcrum::ui {

class BackgroundJob;
class JobBar;
class LimitsChart;

class BenchmarkPage : public Page {
    Q_OBJECT
  public:
    explicit BenchmarkPage(Context& context);
    void enter() override;
    void leave() override;
    /// Nothing is being read or built.
    bool is_ready() const { return job_ == nullptr; }
    QStringList begun_input(Ending ending) const override;

  private:
    /// What came of it, with what it is compared with.
    struct Built {
        TaskDefinition task;
        BenchmarkBuild build;
        std::optional<BenchmarkSet> in_force;
        std::vector<TriedAttempt> attempts;
    };
    QFrame* make_choice();
    QFrame* make_experts();
    QFrame* make_result();
    QWidget* make_saving();
    const TaskDefinition* task() const;
    BenchmarkKey key() const;
    /// Task, class of devices and what else is not usual.
    QString key_text(const BenchmarkKey& key) const;
    void choose_task();
    void choose_key();
    void show_candidates(std::vector<ExpertCandidate> candidates);
    void show_left(const std::optional<BenchmarkSet>& in_force);
    std::vector<ExpertCandidate> chosen() const;
    void keep_ticks();
    void look();
    void build();
    void show_result();
    void fill_passes();
    QStringList explained() const;
    QString limits_of_site() const;
    void put_in_force();
    void save();
    void run(std::function<void(const database::Store&, const std::function<bool(double)>&)> work,
             std::function<void()> done, const QString& line);

    std::vector<ExpertCandidate> candidates_;
    bool known_ = false;  ///< whose attempts there are; else reading them failed, was stopped or runs
    std::optional<Built> built_;
    std::map<std::string, std::set<std::string>> ticked_;  ///< ids of the people who are chosen for each key
    /// By name: what was chosen or built for them is neither in force nor in a file.
    std::map<std::string, BenchmarkKey> unsaved_;
    BackgroundJob* job_ = nullptr;
    JobBar* job_bar_;
    QComboBox *tasks_, *variants_, *devices_, *fidelities_;
    QTableWidget *people_, *passes_;
    QPushButton *build_, *put_, *save_;
    QLabel *left_, *count_, *verdict_, *explained_, *site_, *dots_;
    QFrame* result_;
    QWidget* saving_;
    LimitsChart* chart_;
    QLineEdit *note_, *path_;
};

}  // namespace fulcrum::ui
