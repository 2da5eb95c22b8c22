// SPDX-License-Identifier: Apache-2.0
#include "sim_core/igtl/server.h"

#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>

#include "sim_core/numerics/input_error.h"

namespace fulcrum::igtl {
namespace {

Address own_address(int port) {
    return {"127.0.0.1", port};
}

ServedFrame small_frame(float x) {
    ServedFrame frame;
    Transform transform;
    transform.values[9] = x;
    append_transform(frame.transforms, "Tip", 1, transform);
    const Tracked tracked{"Tip", 2, transform};
    append_tdata(frame.tdata, "All", 1, &tracked, 1);
    return frame;
}

/// A client of the server under test, which runs in the same thread.
struct Peer {
    explicit Peer(Server& server) : connection(own_address(server.port()), 1000) {
        for (int i = 0; i < 100 && server.clients() == 0; ++i) server.step(10);
        server.step(0);
    }
    /// Types of the messages that have arrived.
    std::vector<std::string> receive(Server& server) {
        std::vector<std::string> types;
        for (int i = 0; i < 20; ++i) {
            server.step(0);
            connection.wait(1);
            open = connection.read_into(decoder);
            Message message;
            for (auto found = decoder.next(message); found != Decoder::Found::nothing;
                 found = decoder.next(message)) {
                EXPECT_EQ(found, Decoder::Found::message);
                types.emplace_back(message.type);
            }
            if (!types.empty() || !open) break;
        }
        return types;
    }
    Connection connection;
    Decoder decoder;
    bool open = true;
};

TEST(IgtlServer, EveryClientGetsTheGreetingAndThenEachFrame) {
    Server server(own_address(0));
    Bytes greeting;
    append_string(greeting, "Hello", 0, "a");
    server.greet_with(greeting);
    Peer one(server), two(server);
    ASSERT_EQ(server.clients(), 2U);
    EXPECT_EQ(one.receive(server), std::vector<std::string>{"STRING"});
    EXPECT_EQ(two.receive(server), std::vector<std::string>{"STRING"});
    server.send(small_frame(1), 0);
    EXPECT_EQ(one.receive(server), std::vector<std::string>{"TRANSFORM"});
    EXPECT_EQ(two.receive(server), std::vector<std::string>{"TRANSFORM"});
}

TEST(IgtlServer, AClientThatAsksGetsTdataAtItsOwnRateUntilItAsksForTheEnd) {
    Server server(own_address(0));
    Peer asks(server), other(server);
    Bytes request;
    append_status(request, "", 0, {1, 0, "", ""}, 2);  // what 3D Slicer sends when it connects
    append_start_tracking(request, "", 0, {50, "Patient"}, 2);
    ASSERT_TRUE(asks.connection.send(request));
    for (int i = 0; i < 20; ++i) server.step(1);
    int frames = 0;
    for (std::int64_t now = 1000; now < 1200; now += 10) {
        server.send(small_frame(1), now);
        for (const std::string& type : asks.receive(server)) {
            EXPECT_EQ(type, "TDATA");
            ++frames;
        }
    }
    EXPECT_EQ(frames, 4);
    EXPECT_FALSE(other.receive(server).empty());
    Bytes end;
    append_stop_tracking(end, "", 0);
    ASSERT_TRUE(asks.connection.send(end));
    for (int i = 0; i < 20; ++i) server.step(1);
    server.send(small_frame(2), 5000);
    EXPECT_EQ(asks.receive(server), std::vector<std::string>{"TRANSFORM"});
}

TEST(IgtlServer, AClientThatDoesNotReadIsDroppedAndTheOthersGetEverything) {
    Server server(own_address(0));
    Peer slow(server), good(server);
    ServedFrame frame;
    const std::string text(60000, 'x');
    append_string(frame.others, "Big", 0, text);
    std::size_t received = 0;
    int sent = 0;
    while (server.dropped() == 0 && sent < 2000) {
        server.send(frame, 0);
        ++sent;
        received += good.receive(server).size();
    }
    EXPECT_EQ(server.dropped(), 1U);
    EXPECT_EQ(server.clients(), 1U);
    for (int i = 0; i < 200 && received < static_cast<std::size_t>(sent); ++i)
        received += good.receive(server).size();
    EXPECT_EQ(received, static_cast<std::size_t>(sent));
    // Of two that are behind, the one that is further behind goes.
    Peer another(server);
    for (int i = 0; i < 400 && server.backlog() < 300000; ++i) {
        server.send(frame, 0);
        good.receive(server);
    }
    ASSERT_GE(server.backlog(), 300000U);
    server.drop_behind(200000);
    EXPECT_EQ(server.clients(), 1U);
    EXPECT_EQ(server.dropped(), 2U);
}

TEST(IgtlServer, AClientThatSendsSomethingElseIsDroppedAndOneThatLeavesIsForgotten) {
    Server server(own_address(0));
    Peer noise(server);
    const std::string text = "GET / HTTP/1.1\r\n\r\n";
    ASSERT_TRUE(noise.connection.send(Bytes(text.begin(), text.end())));
    for (int i = 0; i < 50 && server.clients() > 0; ++i) server.step(5);
    EXPECT_EQ(server.clients(), 0U);
    EXPECT_EQ(server.dropped(), 1U);
    {
        Peer leaves(server);
        EXPECT_EQ(server.clients(), 1U);
    }
    for (int i = 0; i < 50 && server.clients() > 0; ++i) {
        server.send(small_frame(0), 0);
        server.step(5);
    }
    EXPECT_EQ(server.clients(), 0U);
    EXPECT_EQ(server.dropped(), 1U) << "it left by itself";
}

TEST(IgtlServer, AClientThatSendsMessagesOfAnyOtherKindStaysConnected) {
    Server server(own_address(0));
    Peer talks(server);
    Bytes sent;
    const Bytes small(40, 1), large(largest_body + 1000, 1);
    for (const auto version : {std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{3}}) {
        for (const char* const type :
             {"GET_CAPABIL", "GET_STATUS", "GET_TRANS", "STP_TDATA", "NOT_IN_BOOK"}) {
            Envelope envelope;
            envelope.type = type;
            envelope.version = version;
            append_message(sent, envelope, {});
            append_message(sent, envelope, {small.data(), small.size()});
        }
        append_status(sent, "Other", 1, {1, 0, "OK", "connected"}, version);
        append_transform(sent, "Probe", 1, Transform(), version);
        append_string(sent, "Note", 1, "hello", 3, version);
        Envelope image;
        image.type = "IMAGE";
        image.version = version;
        append_message(sent, image, {large.data(), large.size()});
        append_string(sent, "Note", 1, "with a wrong checksum", 3, version);
        sent.back() = static_cast<std::uint8_t>(sent.back() ^ 1U);
    }
    append_start_tracking(sent, "", 0, {0, "Patient"});  // the answer shows that all before it was read
    for (std::size_t at = 0; at < sent.size(); at += 10000) {
        const auto from = sent.begin() + static_cast<std::ptrdiff_t>(at);
        const auto count = static_cast<std::ptrdiff_t>(std::min<std::size_t>(10000, sent.size() - at));
        ASSERT_TRUE(talks.connection.send(Bytes(from, from + count)));
        server.step(10);
    }
    std::vector<std::string> types;
    for (std::int64_t now = 1; now < 100 && types.empty(); ++now) {
        server.step(5);
        ServedFrame frame = small_frame(1);
        frame.transforms.clear();
        server.send(frame, now);
        types = talks.receive(server);
    }
    ASSERT_FALSE(types.empty());
    EXPECT_EQ(types[0], "TDATA");
    EXPECT_EQ(server.clients(), 1U);
    EXPECT_EQ(server.dropped(), 0U);
}

TEST(IgtlServer, NoMoreThanSixteenClients) {
    Server server(own_address(0));
    std::vector<std::unique_ptr<Connection>> many;
    for (std::size_t i = 0; i < most_clients + 4; ++i) {
        many.push_back(std::make_unique<Connection>(own_address(server.port()), 1000));
        server.step(5);
    }
    EXPECT_EQ(server.clients(), most_clients);
}

TEST(IgtlServer, APortInUseIsNamedWithWhatToDo) {
    const Server first(own_address(0));
    try {
        const Server second(own_address(first.port()));
        FAIL();
    } catch (const InputError& error) {
        const std::string what = error.what();
        EXPECT_NE(what.find("127.0.0.1:" + std::to_string(first.port()) + ": cannot be served: Address"),
                  std::string::npos)
            << what;
        EXPECT_NE(what.find("choose another port"), std::string::npos);
    }
}

TEST(IgtlServer, AddressesAreRead) {
    EXPECT_EQ(parse_address("", "x").text(), "127.0.0.1:18944");
    EXPECT_EQ(parse_address(":5000", "x").text(), "127.0.0.1:5000");
    EXPECT_EQ(parse_address("host", "x").text(), "host:18944");
    EXPECT_EQ(parse_address("host:7", "x").text(), "host:7");
    EXPECT_EQ(parse_address("[::1]", "x").text(), "[::1]:18944");
    EXPECT_EQ(parse_address("[fe80::1]:8", "x").text(), "[fe80::1]:8");
    for (const char* wrong : {"host:", "host:0", "host:65536", "host:-1", "host:+1", "host: 1", "::1",
                              "a b:1", "[::1", "[::1]x", "host:1x"}) {
        if (std::string(wrong) == "host:") {
            EXPECT_EQ(parse_address(wrong, "x").port, standard_port);
            continue;
        }
        EXPECT_THROW(parse_address(wrong, "x"), InputError) << wrong;
    }
}

}  // namespace
}  // namespace fulcrum::igtl
