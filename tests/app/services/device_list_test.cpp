// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/services/device_list.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/support/own_folder.h"

namespace fulcrum::app::program_test {
namespace {

void plug_in(const std::filesystem::path& folder, const char* port, const char* vendor, const char* product,
             const char* title) {
    std::filesystem::create_directories(folder / port);
    std::ofstream(folder / port / "idVendor") << vendor << '\n';
    std::ofstream(folder / port / "idProduct") << product << '\n';
    if (*title != '\0') std::ofstream(folder / port / "product") << title << '\n';
}

const ListedDevice& row(const std::vector<ListedDevice>& devices, const std::string& kind) {
    for (const ListedDevice& device : devices)
        if (device.kind == kind) return device;
    ADD_FAILURE() << kind;
    return devices.front();
}

Machine machine_with(const std::filesystem::path& usb, const std::string& daemon) {
    Machine machine;
    machine.usb = {usb.string(), (usb / "dev").string()};
    machine.daemon = daemon;
    machine.may_open = [](const std::string&) { return true; };
    machine.look = [](const std::string&) { return LibraryLook{}; };
    return machine;
}

TEST(DeviceList, EveryDeviceThatCannotBeUsedSaysWhyAndWhatToDo) {
    const fulcrum::test::OwnFolder usb;
    plug_in(usb.path(), "1-1", "2988", "0302", "Touch");
    plug_in(usb.path(), "1-2", "0403", "6001",
            "serial adapter");  // the vendor of a Falcon's chip, not a Falcon
    plug_in(usb.path(), "usb1", "1d6b", "0002", "");
    for (const bool display : {false, true}) {
        for (const std::vector<std::string>& mice : {std::vector<std::string>{}, {"one"}, {"one", "two"}}) {
            Machine machine = machine_with(usb.path(), "/none/fulcrum-hapticd");
            machine.display = display;
            machine.mice = mice;
            const auto devices = list_devices(machine);
            for (const ListedDevice& device : devices) {
                const bool usable = device.state == DeviceState::usable;
                EXPECT_EQ(device.why.empty(), usable) << device.kind;
                EXPECT_EQ(device.what_to_do.empty(), usable) << device.kind;
            }
            EXPECT_EQ(row(devices, "touch").state, DeviceState::connected);
            EXPECT_EQ(row(devices, "touch").found, std::vector<std::string>{"Touch (2988:0302)"});
            EXPECT_EQ(row(devices, "force-dimension").state, DeviceState::absent);
            EXPECT_EQ(row(devices, "two-mice").state, mice.size() == 2   ? DeviceState::usable
                                                      : mice.size() == 1 ? DeviceState::connected
                                                                         : DeviceState::absent);
            EXPECT_EQ(row(devices, "mouse-keyboard").state,
                      display ? DeviceState::usable : DeviceState::absent);
            EXPECT_NE(row(devices, "virtual").why.find("/none/fulcrum-hapticd"), std::string::npos);
            EXPECT_EQ(devices_json(devices).size(), devices.size());
        }
    }
}

TEST(DeviceList, GameControllersAreUsableWhereSdlKnowsThem) {
    Machine machine = machine_with("/none", "/bin/sh");
    ControllerLook look;
    machine.controllers = [&look] { return look; };
    const auto listed = [&] { return row(list_devices(machine), "controller"); };
    EXPECT_EQ(listed().state, DeviceState::absent);
    EXPECT_FALSE(listed().what_to_do.empty());
    look.connected = {{"Odd Stick", false}};
    EXPECT_EQ(listed().state, DeviceState::connected);
    EXPECT_NE(listed().what_to_do.find("SDL_GAMECONTROLLERCONFIG"), std::string::npos);
    look.connected.push_back({"Fake Pad", true});
    EXPECT_EQ(listed().state, DeviceState::usable);
    EXPECT_EQ(listed().found,
              (std::vector<std::string>{"Odd Stick", "Fake Pad", "FULCRUM_DEVICE=controller"}));
    EXPECT_TRUE(listed().why.empty() && listed().what_to_do.empty());
    look.library = {LibraryState::missing, "libSDL2-2.0.so.0: cannot open"};
    EXPECT_EQ(listed().state, DeviceState::absent);
    EXPECT_EQ(listed().detail, "libSDL2-2.0.so.0: cannot open");
    look = {};
    look.failure = "no udev";
    EXPECT_EQ(listed().detail, "no udev");
}

/// In no language: the page of settings shows it in all of them.
TEST(DeviceList, ADeviceThatDoesNotNameItselfIsShownByItsNumbers) {
    const fulcrum::test::OwnFolder usb;
    plug_in(usb.path(), "1-1", "2988", "0302", "");
    const auto devices = list_devices(machine_with(usb.path(), "/none/fulcrum-hapticd"));
    EXPECT_EQ(row(devices, "touch").found, std::vector<std::string>{"USB 2988:0302"});
}

TEST(DeviceList, ASystemWithoutAListOfUsbDevicesHasNone) {
    const auto devices = list_devices(machine_with("/none", "/bin/sh"));
    EXPECT_EQ(row(devices, "touch").state, DeviceState::absent);
    EXPECT_NE(row(devices, "touch").why.find("no USB device"), std::string::npos);
    EXPECT_EQ(row(devices, "virtual").state, DeviceState::usable);
}

TEST(DeviceList, ATouchIsUsableOnlyWithItsLibraryAndTheRightToOpenEachOfItsFiles) {
    const fulcrum::test::OwnFolder usb;
    plug_in(usb.path(), "1-1", "2988", "0302", "Touch");
    std::ofstream(usb.path() / "1-1" / "busnum") << "1\n";
    std::ofstream(usb.path() / "1-1" / "devnum") << "7\n";
    std::filesystem::create_directories(usb.path() / "1-1" / "1-1:1.0" / "tty" / "ttyACM0");
    std::filesystem::create_directories(usb.path() / "1-1" / "1-1:1.1" / "hidraw" / "hidraw3");
    std::filesystem::create_directories(usb.path() / "dev" / "bus" / "usb" / "001");
    const std::vector<std::string> nodes = {"bus/usb/001/007", "hidraw3", "ttyACM0"};
    for (const std::string& node : nodes) std::ofstream(usb.path() / "dev" / node) << "";
    Machine machine = machine_with(usb.path(), "/bin/sh");
    EXPECT_EQ(row(list_devices(machine), "touch").state, DeviceState::usable);
    EXPECT_EQ(row(list_devices(machine), "touch").found.back(), "FULCRUM_DEVICE=touch");
    for (const std::string& node : nodes) {
        const std::string path = (usb.path() / "dev" / node).string();
        machine.may_open = [&path](const std::string& file) { return file != path; };
        const ListedDevice touch = row(list_devices(machine), "touch");
        EXPECT_EQ(touch.state, DeviceState::connected);
        EXPECT_NE(touch.why.find("permission"), std::string::npos);
        EXPECT_EQ(touch.detail, path);
        EXPECT_NE(touch.what_to_do.find("/etc/udev/rules.d/"), std::string::npos);
    }
    for (const LibraryState state :
         {LibraryState::missing, LibraryState::incomplete, LibraryState::outdated, LibraryState::unusable}) {
        machine.look = [state](const std::string&) { return LibraryLook{state, "libHD.so"}; };
        const ListedDevice touch = row(list_devices(machine), "touch");
        EXPECT_EQ(touch.state, DeviceState::connected);
        EXPECT_EQ(touch.why, problem_of(state));
        EXPECT_EQ(touch.detail, "libHD.so");
        EXPECT_FALSE(touch.what_to_do.empty());
        EXPECT_EQ(devices_json({touch})[0]["detail"], "libHD.so");
    }
}

TEST(DeviceList, ASpaceMouseIsUsableWhereSpacenavdListens) {
    const fulcrum::test::OwnFolder usb;
    Machine machine = machine_with(usb.path(), "/bin/sh");
    machine.spacenavd = (usb.path() / "spnav.sock").string();
    const auto listed = [&] { return row(list_devices(machine), "space-mouse"); };
    EXPECT_EQ(listed().state, DeviceState::absent);
    EXPECT_NE(listed().what_to_do.find("systemctl restart spacenavd"), std::string::npos);
    EXPECT_EQ(listed().detail, machine.spacenavd + ": No such file or directory");
    plug_in(usb.path(), "1-3", "256f", "c635", "SpaceMouse Compact");
    EXPECT_EQ(listed().state, DeviceState::connected);
    std::ofstream(machine.spacenavd) << "";
    EXPECT_EQ(listed().state, DeviceState::usable);
    EXPECT_EQ(listed().found,
              (std::vector<std::string>{"SpaceMouse Compact (256f:c635)", "FULCRUM_DEVICE=space-mouse"}));
}

TEST(DeviceList, ASocketOfSpacenavdWithoutPermissionIsNamedAsSuch) {
    const fulcrum::test::OwnFolder usb;
    Machine machine = machine_with(usb.path(), "/bin/sh");
    machine.spacenavd = (usb.path() / "spnav.sock").string();
    std::ofstream(machine.spacenavd) << "";
    ASSERT_EQ(chmod(machine.spacenavd.c_str(), 0), 0);
    const pid_t child = fork();
    if (child == 0) {  // root may use any socket
        if (getuid() == 0 && setuid(65534) != 0) _exit(2);
        const ListedDevice listed = row(list_devices(machine), "space-mouse");
        _exit(listed.why.find("no permission to use its socket") != std::string::npos &&
                      listed.what_to_do.find("read and write the socket") != std::string::npos &&
                      listed.detail == machine.spacenavd + ": Permission denied"
                  ? 0
                  : 1);
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_EQ(status, 0);
}

TEST(DeviceList, ATrainerIsUsableWhereOneSerialPortOfABoardMayBeOpened) {
    const fulcrum::test::OwnFolder usb;
    Machine machine = machine_with(usb.path(), "/bin/true");
    const auto listed = [&] { return row(list_devices(machine), "trainer"); };
    const auto plug_board = [&](const char* port, const char* tty) {
        plug_in(usb.path(), port, "2341", "0043", "Arduino Uno");
        std::filesystem::create_directories(usb.path() / port / (std::string(port) + ":1.0") / "tty" / tty);
        std::filesystem::create_directories(usb.path() / "dev");
        std::ofstream(usb.path() / "dev" / tty) << "";
    };
    EXPECT_EQ(listed().state, DeviceState::absent);
    EXPECT_NE(listed().what_to_do.find("FULCRUM_DEVICE=trainer:PORT"), std::string::npos);
    plug_board("1-1", "ttyACM0");
    EXPECT_EQ(listed().state, DeviceState::usable);
    EXPECT_EQ(listed().found,
              (std::vector<std::string>{"Arduino Uno (2341:0043)", "FULCRUM_DEVICE=trainer"}));
    EXPECT_EQ(listed().device_class, DeviceClass::tracked);
    machine.may_open = [](const std::string&) { return false; };
    EXPECT_EQ(listed().state, DeviceState::connected);
    EXPECT_EQ(listed().detail, (usb.path() / "dev" / "ttyACM0").string());
    EXPECT_NE(listed().what_to_do.find("usermod -aG dialout"), std::string::npos);
    machine.may_open = [](const std::string&) { return true; };
    plug_board("1-2", "ttyACM1");
    EXPECT_EQ(listed().state, DeviceState::connected);
    EXPECT_NE(listed().detail.find("ttyACM0, "), std::string::npos);
    EXPECT_NE(listed().what_to_do.find("name the port"), std::string::npos);
}

TEST(DeviceList, ATrackersServerOnThisComputerIsFoundWithoutConnecting) {
    const fulcrum::test::OwnFolder usb, net;
    Machine machine = machine_with(usb.path(), "/bin/true");
    machine.sockets = net.path().string();
    EXPECT_EQ(row(list_devices(machine), "openigtlink").state, DeviceState::absent);
    EXPECT_NE(row(list_devices(machine), "openigtlink").what_to_do.find("openigtlink:HOST:PORT"),
              std::string::npos);
    const auto socket_is = [&](const char* file, const char* state) {
        std::ofstream(net.path() / file) << "  sl  local_address rem_address   st tx_queue rx_queue\n"
                                         << "   0: 0100007F:1F90 00000000:0000 0A 0:0\n"
                                         << "   1: 0100007F:4A00 00000000:0000 " << state << " 0:0\n";
    };
    socket_is("tcp", "06");  // a connection that is closing
    EXPECT_EQ(row(list_devices(machine), "openigtlink").state, DeviceState::absent);
    socket_is("tcp6", "0A");
    const ListedDevice found = row(list_devices(machine), "openigtlink");
    EXPECT_EQ(found.state, DeviceState::usable);
    EXPECT_EQ(found.found, std::vector<std::string>{"FULCRUM_DEVICE=openigtlink:127.0.0.1:18944"});
    machine.sends_at = "127.0.0.1:18944";
    EXPECT_EQ(row(list_devices(machine), "openigtlink").state, DeviceState::absent);
}

TEST(DeviceList, TheServiceOfHaplyIsFoundAtEitherOfItsPorts) {
    const fulcrum::test::OwnFolder usb, net;
    Machine machine = machine_with(usb.path(), "/bin/true");
    machine.sockets = net.path().string();
    const auto listed = [&] { return row(list_devices(machine), "haply"); };
    EXPECT_EQ(listed().state, DeviceState::absent);
    EXPECT_NE(listed().why.find("does not run"), std::string::npos);
    EXPECT_NE(listed().what_to_do.find("install the Inverse service from Haply"), std::string::npos);
    for (const char* port : {"2711", "2710"}) {  // 10001, 10000
        std::ofstream(net.path() / "tcp") << "   0: 0100007F:" << port << " 00000000:0000 0A 0:0\n";
        EXPECT_EQ(listed().state, DeviceState::usable) << port;
        EXPECT_EQ(listed().found, std::vector<std::string>{"FULCRUM_DEVICE=haply"});
    }
    machine.daemon = "/nowhere/fulcrum-hapticd";
    EXPECT_EQ(listed().state, DeviceState::absent);
}

}  // namespace
}  // namespace fulcrum::app::program_test
