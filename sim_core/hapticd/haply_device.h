// SPDX-License-Identifier: Apache-2.0
// Haply Inverse3, one or two, with VerseGrip styli, through the Inverse service that runs on this computer
// (docs/DEVICES.md, Haply). Nothing of the maker is linked or loaded: a thread of its own exchanges JSON with
// the service over a WebSocket of 127.0.0.1, one answer for each command, up to 1000 times a second. That
// thread allocates; the loop of the device process does not.
#pragma once

#include <array>
#include <atomic>
#include <memory>
#include <thread>

#include "sim_core/haply/messages.h"
#include "sim_core/haply/web_socket.h"
#include "sim_core/hapticd/servo_backend.h"

namespace fulcrum::hapticd {

struct HaplySpecification {
    std::vector<int> ports = {10001, 10000};         ///< of the service, tried in this order
    int events_port = 10020;                         ///< of its event channel; 0: not used
    std::array<std::optional<std::string>, 2> hand;  ///< identity of each hand's device; none: by handedness
    Matrix3 axes;                                    ///< the device frame from the service's
    Vector3 grip = Vector3::UnitZ();                 ///< axis of the grip that points to the tip
};
/// "haply", "haply:PORT,left=ID,…" (docs/DEVICES.md). Throws InputError.
HaplySpecification haply_specification(const std::string& specification);

class HaplyDevice : public ServoBackend {
  public:
    explicit HaplyDevice(HaplySpecification specification);
    ~HaplyDevice() override { close(); }
    void open() override;
    void close() noexcept override;

  private:
    struct Hand {
        std::string id;  // empty: no device
        int grip = -1;   // index among the grips
        double jaw = 1, roll = 0;
        Vector3 asked = Vector3::Zero();  // N, with the newest command, service frame
        ServoReading last;
        FaultMemory memory;
    };
    void connect();
    bool try_port(int port);
    void end_exchange();
    haply::Message first_message();
    void choose(const haply::Message& inventory);
    std::string used_elsewhere(const haply::Message& inventory) const;
    void require_free(const haply::Message& inventory);
    void command();
    void take_arrived();
    void take_hand(Hand& hand, const haply::Message& message, std::int64_t now);
    void take_event(const haply::Event& event, std::int64_t now);
    void check_form(const Hand& hand, const haply::Inverse3& device);
    void publish_all(std::int64_t now);
    void see(DeviceFault fault, std::int64_t now);
    void run();
    void exchange(std::int64_t& due);

    HaplySpecification wanted_;
    std::string where_;  // the service, for messages
    std::unique_ptr<haply::WebSocket> service_, events_;
    haply::ForceForm form_ = haply::ForceForm::vector;
    int not_rendered_ = 0;  // answers in a row without the force that was asked for
    bool answered_ = true;
    std::int64_t read_at_ = 0;
    Hand hands_[2];
    std::atomic<bool> stop_{false};
    std::thread thread_;
};

inline constexpr Maker haply_maker = {"haply", make_device<HaplyDevice, haply_specification>};

}  // namespace fulcrum::hapticd
