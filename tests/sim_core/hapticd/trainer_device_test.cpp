// SPDX-License-Identifier: Apache-2.0
// A trainer through its real entry: fulcrum-hapticd opens a pseudo-terminal whose other end a trainer of the
// test has, or the sketch for a micro-controller itself.
#include "sim_core/hapticd/trainer_device.h"

#include <gtest/gtest.h>

#include "sim_core/devices/daemon_client.h"
#include "sim_core/numerics/input_error.h"
#include "tests/fakes/arduino.h"
#include "tests/fakes/fake_page.h"
#include "tests/support/allocation_count.h"
#include "tests/support/built.h"
#include "tests/support/fake_trainer.h"
#include "tests/support/process_rights.h"

namespace fulcrum::test::arduino {
namespace one {
#define TWO_INSTRUMENTS 0
#include "docs/trainer/trainer.ino"
#undef TWO_INSTRUMENTS
}  // namespace one
namespace two {
#define TWO_INSTRUMENTS 1
#include "docs/trainer/trainer.ino"
#undef TWO_INSTRUMENTS
}  // namespace two
}  // namespace fulcrum::test::arduino

namespace fulcrum {
namespace {

using hapticd::handle_of;
using hapticd::read_trainer_line;
using hapticd::trainer_line;
using hapticd::trainer_specification;
using hapticd::TrainerDecoder;
using hapticd::TrainerDevice;
using hapticd::TrainerMessage;
using hapticd::TrainerPose;
using test::FakeTrainer;
using test::until;
using Kind = TrainerMessage::Kind;
using Mode = FakeTrainer::Mode;

/// With its checksum, without its end.
TrainerMessage read_body(const std::string& body) {
    std::string line = trainer_line(body);
    line.pop_back();
    return read_trainer_line(line);
}

DevicePose trainer_pose(const DaemonClient& client, int slot) {
    DevicePose newest;
    client.state().pose[slot].read(newest);
    return newest;
}
bool trainer_present(const DaemonClient& client, int slot) {
    return trainer_pose(client, slot).present == 1;
}

std::string trainer_error(const std::string& specification) {
    try {
        DaemonClient client(test::hapticd_program(), specification);
    } catch (const InputError& error) {
        return error.what();
    }
    return "opened";
}

TEST(TrainerLine, IsReadWithItsUnits) {
    EXPECT_EQ(hapticd::trainer_checksum("123456789"), 0x29B1) << "CRC-16/CCITT-FALSE";
    const TrainerMessage pose = read_body("F1,P,65535,4294967295,L,-250000,1500000,123456,-7000000,250,12");
    ASSERT_EQ(pose.kind, Kind::pose);
    EXPECT_EQ(pose.pose.sequence, 65535);
    EXPECT_EQ(pose.pose.time_us, 4294967295U);
    EXPECT_EQ(pose.pose.part, 0U);
    EXPECT_DOUBLE_EQ(pose.pose.pitch, -0.25);
    EXPECT_DOUBLE_EQ(pose.pose.yaw, 1.5);
    EXPECT_DOUBLE_EQ(pose.pose.insertion, 0.123456);
    EXPECT_DOUBLE_EQ(pose.pose.roll, -7);
    EXPECT_DOUBLE_EQ(pose.pose.jaw, 0.25);
    EXPECT_EQ(pose.pose.buttons, std::uint32_t{button_energy} | std::uint32_t{button_exchange});
    const TrainerMessage hello = read_body("F1,H,Box trainer 3,100,RS");
    ASSERT_EQ(hello.kind, Kind::hello);
    EXPECT_STREQ(hello.hello.name.data(), "Box trainer 3");
    EXPECT_EQ(hello.hello.rate, 100);
    EXPECT_TRUE(!hello.hello.part[0] && hello.hello.part[1] && hello.hello.part[2]);
    EXPECT_EQ(read_trainer_line("F1,?*BB67\r").kind, Kind::not_a_line) << "a question is none of ours";
}

TEST(TrainerLine, WhatIsWrongIsNotUsedAndNamed) {
    const std::string good = "F1,P,1,2,R,0,0,100000,0,1000,0";
    ASSERT_EQ(read_body(good).kind, Kind::pose);
    for (const char* wrong : {"F1,P,1,2,R,nan,0,100000,0,1000,0",
                              "F1,P,1,2,R,1e3,0,100000,0,1000,0",
                              "F1,P,1,2,R,inf,0,100000,0,1000,0",
                              "F1,P,1,2,R,0,0,100000,0,1000",
                              "F1,P,1,2,R,0,0,100000,0,1000,",
                              "F1,P,1,2,R,0,0,100000,0,1000,0,0",
                              "F1,P,1,2,R,1500001,0,100000,0,1000,0",
                              "F1,P,1,2,R,0,-1500001,100000,0,1000,0",
                              "F1,P,1,2,R,0,0,400001,0,1000,0",
                              "F1,P,1,2,R,0,0,-1,0,1000,0",
                              "F1,P,1,2,R,0,0,100000,2000000001,1000,0",
                              "F1,P,1,2,R,0,0,100000,0,1001,0",
                              "F1,P,1,2,R,0,0,100000,0,1000,16",
                              "F1,P,65536,2,R,0,0,100000,0,1000,0",
                              "F1,P,1,4294967296,R,0,0,100000,0,1000,0",
                              "F1,P,1,2,X,0,0,100000,0,1000,0",
                              "F1,P,1,2,,0,0,100000,0,1000,0",
                              "F1,P,1,2,RL,0,0,100000,0,1000,0",
                              "F1,P,1,2,R, 0,0,100000,0,1000,0",
                              "F1,P,1,2,R,0.5,0,100000,0,1000,0",
                              "F1,P,1,2,R,99999999999999999999,0,100000,0,1000,0",
                              "F1,H,,100,R",
                              "F1,H,Box,19,R",
                              "F1,H,Box,501,R",
                              "F1,H,Box,100,",
                              "F1,H,Box,100,RR",
                              "F1,H,Box,100,RX",
                              "F1,H,Box,100",
                              "F1,H,B\x01x,100,R",
                              "F1,H,A name of more than thirty-two bytes,100,R"})
        EXPECT_EQ(read_body(wrong).kind, Kind::wrong_values) << wrong;
    EXPECT_EQ(read_body("F2,P,1").kind, Kind::other_version);
    EXPECT_EQ(read_body("F2,P,1").version, 2);
    for (const char* wrong : {"F1,X,1", "G1,P", "F0,P", "F,P", "F-1,P", "hello", "F1"})
        EXPECT_EQ(read_body(wrong).kind, Kind::not_a_line) << wrong;
    EXPECT_EQ(read_trainer_line("").kind, Kind::nothing);
    std::string line = trainer_line(good);
    line.pop_back();
    for (std::size_t i = 0; i < line.size(); ++i)
        for (unsigned bit = 0; bit < 7; ++bit) {
            std::string flipped = line;
            flipped[i] = static_cast<char>(static_cast<unsigned>(flipped[i]) ^ (1U << bit));
            const Kind kind = read_trainer_line(flipped).kind;
            EXPECT_TRUE(kind == Kind::wrong_checksum || kind == Kind::not_a_line ||
                        (i + 4 >= line.size() && bit == 5))  // a letter of the checksum may be small
                << flipped;
            EXPECT_EQ(read_trainer_line(line.substr(0, i)).kind == Kind::pose, false) << "cut off";
        }
}

TEST(TrainerLine, TheDecoderFindsLinesInPiecesOfAnySizeAndAfterRubbish) {
    const std::string stream = "half a li\n" + trainer_line("F1,H,Box,100,R") + std::string(3000, 'A') +
                               "\n" + trainer_line("F1,P,1,2,R,0,0,100000,0,1000,0") + "\r\n\n" +
                               trainer_line("F1,P,2,3,R,0,0,100000,0,1000,0");
    for (const std::size_t piece : {std::size_t{1}, std::size_t{7}, std::size_t{100}, std::size_t{1024}}) {
        TrainerDecoder decoder;
        std::vector<Kind> found;
        for (std::size_t at = 0; at < stream.size();) {
            const std::size_t count = std::min({piece, stream.size() - at, decoder.room()});
            ASSERT_GT(count, 0U);
            stream.copy(decoder.space(), count, at);
            decoder.take(count);
            at += count;
            for (TrainerMessage one = decoder.next(); one.kind != Kind::nothing; one = decoder.next())
                found.push_back(one.kind);
        }
        EXPECT_EQ(found, (std::vector<Kind>{Kind::not_a_line, Kind::hello, Kind::not_a_line, Kind::pose,
                                            Kind::pose}))
            << piece;
    }
}

TEST(TrainerDevice, SpecificationsAndHandles) {
    EXPECT_EQ(trainer_specification("trainer").port, "");
    const auto full = trainer_specification("trainer:/dev/ttyUSB1,baud=57600,length=400");
    EXPECT_EQ(full.port, "/dev/ttyUSB1");
    EXPECT_EQ(full.baud, 57600);
    EXPECT_DOUBLE_EQ(full.length, 0.4);
    EXPECT_EQ(trainer_specification("trainer:baud=9600").port, "");
    for (const char* wrong : {"trainer:/dev/x,baud=1234", "trainer:/dev/x,baud=", "trainer:/dev/x,baud=-1",
                              "trainer:/dev/x,baud", "trainer:/dev/x,length=99", "trainer:/dev/x,length=601",
                              "trainer:/dev/x,/dev/y", "trainer:/dev/x,length=1e2", "trainer:/dev/x,speed=1"})
        EXPECT_THROW(trainer_specification(wrong), InputError) << wrong;
    TrainerPose pose;
    pose.insertion = 0.1;
    EXPECT_TRUE(handle_of(pose, 0.34).position.isApprox(Vector3(0, 0, 0.24))) << "towards the person";
    pose.yaw = 0.5;  // the tip to the right: the handle to the left
    EXPECT_LT(handle_of(pose, 0.34).position.x(), -0.1);
    pose.yaw = 0;
    pose.pitch = 0.5;
    EXPECT_LT(handle_of(pose, 0.34).position.y(), -0.1);
    EXPECT_NEAR(handle_of(pose, 0.34).position.norm(), 0.24, 1e-12);
}

TEST(TrainerOnAPort, MovesItsPartsAndPressesTheirButtons) {
    if (!FakeTrainer::is_possible()) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    FakeTrainer trainer("LRS");
    DaemonClient client(test::hapticd_program(), trainer.specification());
    EXPECT_EQ(client.facts().kind, "trainer");
    EXPECT_EQ(client.facts().title, "Box");
    for (int slot = 0; slot < device_slots; ++slot) {
        EXPECT_TRUE(client.facts().slot[slot]);
        EXPECT_TRUE(until([&] { return trainer_present(client, slot); }));
    }
    EXPECT_TRUE(test::is_filtered(client.device_process())) << "while its port is open";
    EXPECT_FALSE(client.facts().force[0] || client.facts().force[1]);
    const Vector3 handle(0.03, -0.05, 0.21);
    trainer.move('L', handle);
    trainer.hold('L', 250, 4);
    EXPECT_TRUE(until([&] {
        const DevicePose pose = trainer_pose(client, 0);
        return (Vector3(pose.position[0], pose.position[1], pose.position[2]) - handle).norm() < 1e-5 &&
               pose.jaw == 0.25 && pose.buttons == button_energy;
    }));
    EXPECT_NEAR(trainer_pose(client, 1).position[2], 0.24, 1e-6) << "the other one stays";
    client.poll();
    EXPECT_TRUE(client.message().empty());
}

TEST(TrainerOnAPort, EachFaultMakesTheHandAbsentSaysWhatToDoAndPasses) {
    if (!FakeTrainer::is_possible()) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    FakeTrainer trainer("LR");
    DaemonClient client(test::hapticd_program(), trainer.specification());
    ASSERT_TRUE(until([&] { return trainer_present(client, 0) && trainer_present(client, 1); }));
    const auto process = client.device_process();
    const std::pair<Mode, DeviceFault> faults[] = {{Mode::silent, DeviceFault::trainer_silent},
                                                   {Mode::repeated, DeviceFault::trainer_silent},
                                                   {Mode::garbage, DeviceFault::trainer_lines},
                                                   {Mode::wrong_checksum, DeviceFault::trainer_checksum},
                                                   {Mode::not_a_number, DeviceFault::trainer_values},
                                                   {Mode::out_of_range, DeviceFault::trainer_values}};
    for (const auto& [mode, fault] : faults) {
        trainer.mode = mode;
        EXPECT_TRUE(until([&] {
            client.poll();
            return !trainer_present(client, 0) && !trainer_present(client, 1) &&
                   client.message().words() == words_of(fault);
        })) << words_of(fault);
        trainer.mode = Mode::good;
        EXPECT_TRUE(until([&] {
            client.poll();
            return trainer_present(client, 0) && trainer_present(client, 1) && client.message().empty();
        })) << words_of(fault);
    }
    trainer.hidden = 'L';
    EXPECT_TRUE(until([&] { return !trainer_present(client, 0); }));
    EXPECT_TRUE(until([&] { return trainer_present(client, 1); }))
        << "only the hand whose sensors are silent is absent";
    trainer.hidden = '\0';
    EXPECT_TRUE(until([&] { return trainer_present(client, 0); }));
    const int asked = trainer.asked_for;
    trainer.begin_again();
    EXPECT_TRUE(until([&] { return trainer.asked_for > asked; })) << "a board that was reset is asked again";
    EXPECT_TRUE(until([&] { return trainer_present(client, 1); }));
    EXPECT_EQ(client.device_process(), process) << "none of these opens the port again";
}

TEST(TrainerOnAPort, UnpluggedInTheMiddleOfALineItIsOpenedAgainWhenItIsPluggedIn) {
    if (!FakeTrainer::is_possible()) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    FakeTrainer trainer("R");
    DaemonClient client(test::hapticd_program(), trainer.specification());
    ASSERT_TRUE(until([&] { return trainer_present(client, 1); }));
    const auto process = client.device_process();
    trainer.send("F1,P,77,");
    trainer.unplug();
    EXPECT_TRUE(until([&] { return !trainer_present(client, 1); }));
    EXPECT_TRUE(until([&] {
        client.poll();
        return client.message().words().find("lost the device") != std::string::npos ||
               client.message().words() == words_of(DeviceFault::trainer_unplugged);
    }));
    trainer.plug();
    EXPECT_TRUE(until([&] {
        client.poll();
        return client.device_process() != process && trainer_present(client, 1) && client.message().empty();
    }));
}

TEST(TrainerOnAPort, WhatKeepsItFromOpeningSaysWhatToDo) {
    if (!FakeTrainer::is_possible()) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    const auto says = [](const std::string& what, const char* problem, const char* hint) {
        EXPECT_NE(what.find(problem), std::string::npos) << what;
        EXPECT_NE(what.find(hint), std::string::npos) << what;
    };
    says(trainer_error("trainer:/none"), "does not open: No such file", "plug the trainer in");
    FakeTrainer trainer("LR");
    {
        const DaemonClient first(test::hapticd_program(), trainer.specification());
        says(trainer_error(trainer.specification()), "Device or resource busy", "end the other program");
    }
    const test::OwnFolder folder;
    const std::string file = (folder.path() / "file").string();
    std::ofstream(file) << "no port";
    says(trainer_error("trainer:" + file), "Inappropriate ioctl", "name a serial port");
    trainer.mode = Mode::other_version;
    says(trainer_error(trainer.specification()), "version 2 of the protocol, Fulcrum version 1", "sketch");
    // As a person who is not in the group of the port.
    if (geteuid() == 0) {
        const std::string port = std::filesystem::canonical(trainer.port()).string();
        ASSERT_EQ(seteuid(65534), 0);
        const std::string what = trainer_error("trainer:" + port);
        ASSERT_EQ(seteuid(0), 0);
        says(what, "Permission denied", "usermod -aG dialout");
    }
}

TEST(TrainerDevice, AnswersThatAreNoneAreNamedWithWhatToDo) {
    if (!FakeTrainer::is_possible()) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    const std::tuple<Mode, const char*, const char*> answers[] = {
        {Mode::deaf, "no trainer answers", "load the sketch"},
        {Mode::silent, "sends no pose", "reset button"},
        {Mode::garbage, "are not the lines of a trainer", "baud="},
        {Mode::wrong_checksum, "wrong checksums", "shorter cable"},
        {Mode::out_of_range, "not possible", "ranges of its sensors"},
        {Mode::good, "not possible", "ranges of its sensors"}};  // deeper than a short instrument is long
    for (const auto& [mode, problem, hint] : answers) {
        FakeTrainer trainer("R");
        trainer.mode = mode;
        auto wanted =
            trainer_specification(trainer.specification() + (mode == Mode::good ? ",length=100" : ""));
        wanted.patience = (mode == Mode::deaf ? 50 : 300) * 1'000'000;
        TrainerDevice device(wanted);
        try {
            device.open();
            ADD_FAILURE() << problem;
        } catch (const InputError& error) {
            EXPECT_NE(std::string(error.what()).find(problem), std::string::npos) << error.what();
            EXPECT_NE(std::string(error.what()).find(hint), std::string::npos) << error.what();
        }
    }
}

TEST(TrainerDevice, TheLoopAllocatesNothingWhateverArrives) {
    if (!FakeTrainer::is_possible()) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    FakeTrainer trainer("R");
    TrainerDevice device(trainer_specification(trainer.specification()));
    device.open();
    trainer.mode = Mode::deaf;  // the count is that of all threads
    DevicePose poses[device_slots];
    std::string flood(4000, 'x');
    flood += "\n" + trainer_line("F1,P,1,2,R,nan,0,0,0,0,0");
    for (int round = 0; round < 20; ++round) {
        trainer.send(flood);
        EXPECT_EQ(test::allocations_in([&] { device.read(monotonic_ns(), poses); }), 0U);
    }
    trainer.unplug();
    EXPECT_TRUE(until([&] {
        EXPECT_EQ(test::allocations_in([&] { device.read(monotonic_ns(), poses); }), 0U);
        return device.lost();
    }));
    EXPECT_EQ(poses[1].present, 0U);
    EXPECT_EQ(device.fault().fault, static_cast<std::uint64_t>(DeviceFault::trainer_unplugged));
    EXPECT_EQ(device.fault().hands, 2U);
}

TEST(TrainerDevice, ALineThatIsRepeatedIsNothingNewAlsoAfterAnAnswer) {
    if (!FakeTrainer::is_possible()) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    FakeTrainer trainer("R");
    TrainerDevice device(trainer_specification(trainer.specification()));
    device.open();
    DevicePose poses[device_slots];
    std::int64_t now = monotonic_ns();
    const auto read = [&] {
        usleep(1000);
        device.read(now += 10'000'000, poses);
        return poses[1].present;
    };
    trainer.mode = Mode::repeated;
    EXPECT_TRUE(until([&] { return read() == 0; }));
    // It answers when it is asked, and repeats itself.
    const int asked = trainer.asked_for;
    EXPECT_TRUE(until([&] {
        EXPECT_EQ(read(), 0U);
        return trainer.asked_for >= asked + 3;
    }));
    trainer.begin_again();
    trainer.mode = Mode::good;
    EXPECT_TRUE(until([&] { return read() == 1; })) << "it counts from 0 again";
}

TEST(TrainerDevice, LinesThatAreLostLeaveGapsAndTheHandFollowsAlsoWhereTheNumbersBeginAgain) {
    if (!FakeTrainer::is_possible()) GTEST_SKIP() << "this machine gives no terminals: mount /dev/pts";
    FakeTrainer trainer("R");
    trainer.count_from(65530);
    TrainerDevice device(trainer_specification(trainer.specification()));
    device.open();
    trainer.mode = Mode::gaps;
    DevicePose poses[device_slots];
    const auto read = [&] {
        usleep(1000);
        device.read(monotonic_ns(), poses);
        return poses[1];
    };
    ASSERT_TRUE(until([&] { return read().present == 1; }));
    bool always = true;
    double x = 0;
    for (int i = 0; i < 6; ++i) {  // more than the numbers that are left before 0
        trainer.move('R', Vector3(x += 0.005, 0, 0.24));
        EXPECT_TRUE(until([&] {
            const DevicePose now = read();
            always = always && now.present == 1;
            return std::abs(now.position[0] - x) < 1e-4;
        })) << i;
    }
    EXPECT_TRUE(always);
    EXPECT_EQ(device.fault().fault, 0U);
    EXPECT_LT(trainer.counted(), 60000) << "the numbers began again";
}

/// What the sketch sends within `us`, message by message.
std::vector<TrainerMessage> run_sketch(void (*loop)(), std::uint32_t us) {
    test::arduino::board.sent.clear();
    for (const std::uint32_t end = test::arduino::board.micros + us; test::arduino::board.micros < end;
         test::arduino::board.micros += 500)
        loop();
    std::vector<TrainerMessage> messages;
    std::istringstream lines(test::arduino::board.sent);
    for (std::string line; std::getline(lines, line);) messages.push_back(read_trainer_line(line));
    return messages;
}

TEST(TrainerSketch, SpeaksTheProtocolThatFulcrumReads) {
    namespace arduino = test::arduino;
    arduino::board = {};
    arduino::one::asked = arduino::two::asked = false;
    arduino::one::last_frame_us = arduino::two::last_frame_us = 0;
    arduino::one::setup();
    EXPECT_EQ(arduino::board.baud, hapticd::TrainerSpecification().baud);
    EXPECT_EQ(run_sketch(arduino::one::loop, 100'000).size(), 0U) << "it waits to be asked";
    arduino::board.to_read = "rubbish\n" + trainer_line("F1,?");
    arduino::board.analog[arduino::A0] = 1023;  // pitch
    arduino::board.analog[arduino::A2] = 512;   // insertion
    arduino::board.digital[2] = arduino::LOW;   // the pedal
    const auto messages = run_sketch(arduino::one::loop, 100'000);
    ASSERT_GT(messages.size(), 7U);
    ASSERT_EQ(messages[0].kind, Kind::hello);
    EXPECT_TRUE(!messages[0].hello.part[0] && messages[0].hello.part[1]);
    EXPECT_EQ(messages[0].hello.rate, 80);
    for (std::size_t i = 1; i < messages.size(); ++i) {
        ASSERT_EQ(messages[i].kind, Kind::pose) << i;
        const TrainerPose& pose = messages[i].pose;
        EXPECT_EQ(pose.part, 1U);
        EXPECT_NEAR(pose.pitch, 0.785398, 1e-9);
        EXPECT_NEAR(pose.insertion, 0.15, 1e-3);
        EXPECT_EQ(pose.jaw, 0);
        EXPECT_EQ(pose.buttons, std::uint32_t{button_energy});
        if (i < 2) continue;
        EXPECT_EQ(pose.sequence, messages[i - 1].pose.sequence + 1);
        EXPECT_EQ(pose.time_us - messages[i - 1].pose.time_us, 12'500U);
    }
    arduino::board = {};
    arduino::two::setup();
    arduino::board.to_read = trainer_line("F1,?");
    const auto both = run_sketch(arduino::two::loop, 50'000);
    ASSERT_GT(both.size(), 6U);
    EXPECT_TRUE(both[0].hello.part[0] && both[0].hello.part[1]);
    EXPECT_EQ(both[1].pose.part, 1U);
    EXPECT_EQ(both[2].pose.part, 0U);
    EXPECT_EQ(both[1].pose.sequence, both[2].pose.sequence);
}

}  // namespace
}  // namespace fulcrum
