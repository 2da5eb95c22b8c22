// SPDX-License-Identifier: GPL-3.0-or-later
// Two pointers of the X server that a test moves: the server's own and that of a second master, which exists
// while this object does. Real events: they pass through the server and XInput 2.
#pragma once

#include <memory>

namespace fulcrum::app::program_test {

class VirtualMice {
  public:
    VirtualMice();
    ~VirtualMice();
    VirtualMice(const VirtualMice&) = delete;
    VirtualMice& operator=(const VirtualMice&) = delete;
    /// Counts to the right and down, of mouse 0 or 1.
    void move(int mouse, int right, int down);
    void button(int mouse, int number, bool pressed);
    void wheel(int mouse, int notches);
    /// The second mouse is unplugged and plugged in again.
    void unplug_second();
    void plug_in_second();

  private:
    struct Server;
    std::unique_ptr<Server> server_;
};

}  // namespace fulcrum::app::program_test
