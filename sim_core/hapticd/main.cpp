// SPDX-License-Identifier: Apache-2.0
// fulcrum-hapticd: owns a haptic device for the program that starts it (docs/DEVICES.md). It is not started
// by hand: the program passes one end of a socket. With --look it loads the library of a maker, reports
// whether that is complete and ends.
#include <fcntl.h>
#include <unistd.h>

#include <clocale>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>

#include <nlohmann/json.hpp>

#include "sim_core/devices/packets.h"
#include "sim_core/hapticd/backend.h"
#include "sim_core/hapticd/overseer.h"

int main(int argc, char** argv) {
    // Vendors' libraries read and write numbers in the language of the desktop.
    setenv("LC_ALL", "C", 1);
    std::setlocale(LC_ALL, "C");
    std::signal(SIGPIPE, SIG_IGN);
    const std::string words = argc == 4 ? argv[1] : "";
    if (words != "--control" && words != "--look") {
        std::cerr << "fulcrum-hapticd: is started by fulcrum; use `fulcrum devices --test DEVICE`\n";
        return 2;
    }
    char* end = nullptr;
    const long control = std::strtol(argv[2], &end, 10);
    if (*end != '\0' || control < 3 || control > 1023 || fcntl(static_cast<int>(control), F_GETFD) < 0) {
        std::cerr << "fulcrum-hapticd: " << words << ": '" << argv[2]
                  << "' is not an open descriptor; start it with fulcrum\n";
        return 2;
    }
    fcntl(static_cast<int>(control), F_SETFD, FD_CLOEXEC);
    // Whatever a vendor's library prints goes where errors go.
    dup2(STDERR_FILENO, STDOUT_FILENO);
    if (words == "--look") {
        const fulcrum::LibraryLook look = fulcrum::hapticd::look_at_own_library(argv[3]);
        fulcrum::send_packet(static_cast<int>(control),
                             {{"state", static_cast<int>(look.state)}, {"detail", look.detail}});
        return 0;
    }
    return fulcrum::hapticd::oversee(static_cast<int>(control), argv[3]);
}
