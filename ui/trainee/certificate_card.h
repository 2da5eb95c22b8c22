// SPDX-License-Identifier: GPL-3.0-or-later
// The stages that a person has completed, each with its check code and its certificate as PDF.
#pragma once

#include "ui/page/context.h"

class QVBoxLayout;

namespace fulcrum::ui {

class CertificateCard : public QWidget {
    Q_OBJECT
  public:
    explicit CertificateCard(Context& context);
    /// Hidden where there is none. `folder`: where certificates are saved.
    void show_person(const std::string& person_id, const QString& folder);

  private:
    /// The certificate of the stage under this version, "rectal@1".
    void save(const std::string& person_id, const std::string& curriculum, const std::string& stage);

    Context& context_;
    QString folder_;
    QVBoxLayout* lines_;
};

}  // namespace fulcrum::ui
