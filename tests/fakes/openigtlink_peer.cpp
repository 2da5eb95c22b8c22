// SPDX-License-Identifier: Apache-2.0
// Another program that speaks OpenIGTLink: with the library of the protocol's own project (libopenigtlink),
// which shares nothing with sim_core/igtl. It prints a line of JSON for each message that it receives.
//
//   openigtlink_peer read HOST PORT SECONDS [greet] [tdata MS COUNT]
//       Connects and prints what arrives until the connection ends. greet: first sends what other programs
//       send. tdata: asks for TDATA, and after COUNT of them for the end of it.
//   openigtlink_peer serve KIND VERSION SECONDS [tool NAME X Y Z QX QY QZ QW]... [sensor NAME VALUE VALUE]...
//       Prints its port, and sends these 100 times a second to the first client until that leaves. KIND:
//       transform, position, tdata, or asked: tdata from STT_TDATA on. VERSION: of the header, 1 or 2.
#include <igtlCapabilityMessage.h>
#include <igtlClientSocket.h>
#include <igtlImageMessage.h>
#include <igtlMath.h>
#include <igtlMessageHeader.h>
#include <igtlPositionMessage.h>
#include <igtlSensorMessage.h>
#include <igtlServerSocket.h>
#include <igtlStatusMessage.h>
#include <igtlStringMessage.h>
#include <igtlTrackingDataMessage.h>
#include <igtlTransformMessage.h>
#include <igtl_header.h>
#include <igtl_util.h>

#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Clock = std::chrono::steady_clock;
using Words = std::vector<std::string>;

constexpr int reading_wait_ms = 100, serving_wait_ms = 10;

// What is printed.

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20) {
            char code[8];
            std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(byte));
            out += code;
            continue;
        }
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

std::string list_of(const std::vector<double>& values) {
    std::string out = "[";
    for (const double value : values) {
        char text[40];
        std::snprintf(text, sizeof text, "%.17g", value);
        out += (out.size() > 1 ? "," : "") + std::string(std::isfinite(value) ? text : "null");
    }
    return out + ']';
}

/// The columns of the rotation, then the place.
std::string list_of(const igtl::Matrix4x4& matrix) {
    std::vector<double> values;
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) values.push_back(static_cast<double>(matrix[row][column]));
    return list_of(values);
}

void print_line(const std::string& fields) {
    std::printf("{%s}\n", fields.c_str());
    std::fflush(stdout);
}

// What is received.

enum class Got { whole, nothing, closed };

/// Waits for the first byte as long as the socket does; once it has come, for the others until `end`.
Got receive(igtl::Socket* socket, void* to, int size, Clock::time_point end) {
    auto* const bytes = static_cast<char*>(to);
    int have = 0;
    while (have < size) {
        const int more = socket->Receive(bytes + have, size - have, 0);
        if (more == 0) return Got::closed;
        if (more > 0) have += more;
        if (more < 0 && have == 0) return Got::nothing;
        if (Clock::now() > end) return Got::closed;
    }
    return Got::whole;
}

/// The body that follows a header, with its checksum checked by the library.
template <typename Kind>
typename Kind::Pointer body_of(igtl::Socket* socket, igtl::MessageBase* header, Clock::time_point end) {
    typename Kind::Pointer message = Kind::New();
    message->SetMessageHeader(header);
    message->AllocatePack();
    Got got = Got::nothing;
    while (got == Got::nothing && Clock::now() < end)
        got = receive(socket, message->GetPackBodyPointer(), message->GetPackBodySize(), end);
    if (got != Got::whole) throw std::runtime_error("the connection ended within a message");
    if ((message->Unpack(1) & igtl::MessageBase::UNPACK_BODY) == 0)
        throw std::runtime_error("wrong checksum");
    return message;
}

std::string tools_of(igtl::TrackingDataMessage* message) {
    std::string out = ",\"tools\":[";
    for (int i = 0; i < message->GetNumberOfTrackingDataElements(); ++i) {
        igtl::TrackingDataElement::Pointer element;
        message->GetTrackingDataElement(i, element);
        igtl::Matrix4x4 matrix;
        element->GetMatrix(matrix);
        out += (i > 0 ? ",{\"name\":" : "{\"name\":") + quoted(element->GetName());
        out += ",\"kind\":" + std::to_string(static_cast<int>(element->GetType()));
        out += ",\"values\":" + list_of(matrix) + '}';
    }
    return out + ']';
}

/// Further fields of the line, by the type of the message; takes its body in any case.
std::string contents_of(igtl::Socket* socket, igtl::MessageBase* header, Clock::time_point end) {
    const std::string type = header->GetDeviceType();
    if (header->GetBodySizeToRead() == 0) return {};
    if (type == "TRANSFORM") {
        igtl::Matrix4x4 matrix;
        body_of<igtl::TransformMessage>(socket, header, end)->GetMatrix(matrix);
        return ",\"values\":" + list_of(matrix);
    }
    if (type == "TDATA") {
        const auto message = body_of<igtl::TrackingDataMessage>(socket, header, end);
        return tools_of(message.GetPointer());
    }
    if (type == "SENSOR") {
        const auto message = body_of<igtl::SensorMessage>(socket, header, end);
        std::vector<double> values;
        for (unsigned int i = 0; i < message->GetLength(); ++i) values.push_back(message->GetValue(i));
        return ",\"values\":" + list_of(values) + ",\"unit\":" + std::to_string(message->GetUnit());
    }
    if (type == "STRING") {
        const auto message = body_of<igtl::StringMessage>(socket, header, end);
        return ",\"text\":" + quoted(message->GetString()) +
               ",\"encoding\":" + std::to_string(message->GetEncoding());
    }
    if (type == "STATUS") {
        const auto message = body_of<igtl::StatusMessage>(socket, header, end);
        return ",\"code\":" + std::to_string(message->GetCode()) +
               ",\"subcode\":" + std::to_string(message->GetSubCode()) +
               ",\"name\":" + quoted(message->GetErrorName()) +
               ",\"text\":" + quoted(message->GetStatusString());
    }
    if (type == "STT_TDATA") {
        const auto message = body_of<igtl::StartTrackingDataMessage>(socket, header, end);
        return ",\"resolution\":" + std::to_string(message->GetResolution()) +
               ",\"frame\":" + quoted(message->GetCoordinateName());
    }
    body_of<igtl::MessageBase>(socket, header, end);
    return {};
}

/// Prints the next message; its type, or "" where none came. False: the connection has ended.
bool print_next(igtl::Socket* socket, std::string& type, Clock::time_point end) {
    type.clear();
    const igtl::MessageBase::Pointer header = igtl::MessageBase::New();
    header->InitPack();
    const Got got = receive(socket, header->GetPackPointer(), header->GetPackSize(), end);
    if (got != Got::whole) return got == Got::nothing;
    if ((header->Unpack() & igtl::MessageBase::UNPACK_HEADER) == 0)
        throw std::runtime_error("the library does not read this header");
    type = header->GetDeviceType();
    unsigned int seconds = 0, fraction = 0;
    header->GetTimeStamp(&seconds, &fraction);
    const std::string contents = contents_of(socket, header.GetPointer(), end);
    print_line("\"type\":" + quoted(type) + ",\"device\":" + quoted(header->GetDeviceName()) +
               ",\"sec\":" + std::to_string(seconds) + ",\"frac\":" + std::to_string(fraction) + contents);
    return true;
}

// What is sent.

void put_number(std::string& to, std::size_t at, std::size_t size, std::uint64_t value) {
    for (std::size_t i = 0; i < size; ++i) to[at + i] = static_cast<char>(value >> (8 * (size - 1 - i)));
}

/// The bytes of a message. Libraries before 3.0 write header version 1 only: for version 2 its content, as
/// the library packed it, goes between an extended header and an empty table of metadata, as newer ones
/// write them, with the library's checksum.
std::string packed(igtl::MessageBase* message, int version) {
    message->Pack();
    std::string bytes(static_cast<const char*>(message->GetPackPointer()),
                      static_cast<std::size_t>(message->GetPackSize()));
    if (version == 1) return bytes;
    const std::string extended = {0, 12, 0, 2, 0, 0, 0, 0, 0, 0, 0, 1};
    std::string body = extended + bytes.substr(IGTL_HEADER_SIZE);
    body.append(2, '\0');
    bytes.resize(IGTL_HEADER_SIZE);
    put_number(bytes, 0, 2, 2);
    put_number(bytes, 42, 8, body.size());
    auto* const begin = reinterpret_cast<unsigned char*>(&body[0]);
    put_number(bytes, 50, 8, crc64(begin, body.size(), crc64(nullptr, 0, 0)));
    return bytes + body;
}

template <typename Kind>
typename Kind::Pointer new_message(const std::string& device) {
    typename Kind::Pointer message = Kind::New();
    message->SetDeviceName(device.c_str());
    igtl::TimeStamp::Pointer now = igtl::TimeStamp::New();
    now->GetTime();
    message->SetTimeStamp(now);
    return message;
}

void send(igtl::Socket* socket, const std::string& bytes) {
    if (socket->Send(bytes.data(), static_cast<int>(bytes.size())) == 0)
        throw std::runtime_error("the connection ended while something was sent");
}

/// What programs such as 3D Slicer send to a server, or may send: a status, queries, and nodes of a scene
/// that they share, an image among them.
void greet(igtl::Socket* socket) {
    const auto status = new_message<igtl::StatusMessage>("Peer");
    status->SetCode(igtl::StatusMessage::STATUS_OK);
    status->SetErrorName("OK");
    status->SetStatusString("connected");
    const auto transform = new_message<igtl::TransformMessage>("Probe");
    const auto text = new_message<igtl::StringMessage>("Note");
    text->SetString("hello");
    const auto image = new_message<igtl::ImageMessage>("Volume");
    image->SetDimensions(128, 128, 8);
    image->SetSpacing(1.0F, 1.0F, 1.0F);
    image->SetScalarTypeToUint8();
    image->SetSubVolume(128, 128, 8, 0, 0, 0);
    image->AllocateScalars();
    std::memset(image->GetScalarPointer(), 7, static_cast<std::size_t>(image->GetImageSize()));
    igtl::Matrix4x4 matrix;
    igtl::IdentityMatrix(matrix);
    image->SetMatrix(matrix);
    for (const int version : {2, 1}) {
        send(socket, packed(status.GetPointer(), version));
        send(socket, packed(new_message<igtl::GetStatusMessage>("").GetPointer(), version));
        send(socket, packed(new_message<igtl::GetCapabilityMessage>("").GetPointer(), version));
        send(socket, packed(new_message<igtl::GetTransformMessage>("Probe").GetPointer(), version));
        send(socket, packed(transform.GetPointer(), version));
        send(socket, packed(text.GetPointer(), version));
    }
    send(socket, packed(image.GetPointer(), 1));
}

struct Tool {
    std::string name;
    std::array<float, 3> place;       // mm
    std::array<float, 4> quaternion;  // x, y, z, w
};
struct Reading {
    std::string name;
    std::array<double, 2> values;
};
struct Served {
    std::string kind;
    int version = 1;
    std::vector<Tool> tools;
    std::vector<Reading> readings;
};

void matrix_of(Tool tool, igtl::Matrix4x4& matrix) {
    igtl::QuaternionToMatrix(tool.quaternion.data(), matrix);
    for (std::size_t i = 0; i < 3; ++i) matrix[i][3] = tool.place[i];
}

std::string frame_of(const Served& served) {
    std::string bytes;
    const auto tracked = new_message<igtl::TrackingDataMessage>("Tracker");
    for (const Tool& tool : served.tools) {
        igtl::Matrix4x4 matrix;
        matrix_of(tool, matrix);
        if (served.kind == "transform") {
            const auto message = new_message<igtl::TransformMessage>(tool.name);
            message->SetMatrix(matrix);
            bytes += packed(message.GetPointer(), served.version);
        } else if (served.kind == "position") {
            const auto message = new_message<igtl::PositionMessage>(tool.name);
            message->SetPosition(tool.place.data());
            message->SetQuaternion(tool.quaternion.data());
            bytes += packed(message.GetPointer(), served.version);
        } else {
            igtl::TrackingDataElement::Pointer element = igtl::TrackingDataElement::New();
            element->SetName(tool.name.c_str());
            element->SetType(igtl::TrackingDataElement::TYPE_6D);
            element->SetMatrix(matrix);
            tracked->AddTrackingDataElement(element);
        }
    }
    if (tracked->GetNumberOfTrackingDataElements() > 0) bytes += packed(tracked.GetPointer(), served.version);
    for (const Reading& reading : served.readings) {
        const auto message = new_message<igtl::SensorMessage>(reading.name);
        message->SetLength(2);
        for (unsigned int i = 0; i < 2; ++i) message->SetValue(i, reading.values[i]);
        bytes += packed(message.GetPointer(), served.version);
    }
    return bytes;
}

// The two ways to run it.

Clock::time_point after(const std::string& seconds) {
    return Clock::now() + std::chrono::seconds(std::stoi(seconds));
}

int read_all(const Words& words) {
    const Clock::time_point end = after(words.at(3));
    const igtl::ClientSocket::Pointer socket = igtl::ClientSocket::New();
    if (socket->ConnectToServer(words.at(1).c_str(), std::stoi(words.at(2))) != 0)
        throw std::runtime_error("no server answers");
    socket->SetReceiveTimeout(reading_wait_ms);
    print_line("\"type\":\"connected\"");
    int wanted = 0;
    for (std::size_t i = 4; i < words.size(); ++i) {
        if (words[i] == "greet") greet(socket.GetPointer());
        if (words[i] != "tdata") continue;
        const auto request = new_message<igtl::StartTrackingDataMessage>("");
        request->SetResolution(std::stoi(words.at(i + 1)));
        request->SetCoordinateName("Patient");
        send(socket.GetPointer(), packed(request.GetPointer(), 1));
        wanted = std::stoi(words.at(i + 2));
    }
    int received = 0;
    std::string type;
    while (Clock::now() < end && print_next(socket.GetPointer(), type, end)) {
        if (type != "TDATA" || ++received != wanted) continue;
        const auto request = new_message<igtl::StopTrackingDataMessage>("");
        send(socket.GetPointer(), packed(request.GetPointer(), 1));
    }
    return 0;
}

Served served_of(const Words& words) {
    Served served;
    served.kind = words.at(1);
    served.version = std::stoi(words.at(2));
    for (std::size_t i = 4; i < words.size();) {
        if (words[i] == "tool") {
            Tool tool;
            tool.name = words.at(i + 1);
            for (std::size_t k = 0; k < 3; ++k) tool.place[k] = std::stof(words.at(i + 2 + k));
            for (std::size_t k = 0; k < 4; ++k) tool.quaternion[k] = std::stof(words.at(i + 5 + k));
            served.tools.push_back(tool);
            i += 9;
        } else if (words[i] == "sensor") {
            served.readings.push_back(
                {words.at(i + 1), {std::stod(words.at(i + 2)), std::stod(words.at(i + 3))}});
            i += 4;
        } else {
            throw std::runtime_error("unknown word: " + words[i]);
        }
    }
    return served;
}

int serve(const Words& words) {
    const Served served = served_of(words);
    const Clock::time_point end = after(words.at(3));
    const igtl::ServerSocket::Pointer server = igtl::ServerSocket::New();
    if (server->CreateServer(0) != 0) throw std::runtime_error("no port is free");
    print_line("\"type\":\"port\",\"port\":" + std::to_string(server->GetServerPort()));
    igtl::ClientSocket::Pointer client;
    while (client.IsNull() && Clock::now() < end) client = server->WaitForConnection(serving_wait_ms);
    if (client.IsNull()) return 0;
    client->SetReceiveTimeout(serving_wait_ms);  // which is the time between two frames
    bool sends = served.kind != "asked";
    std::string type;
    while (Clock::now() < end && print_next(client.GetPointer(), type, end)) {
        if (type == "STT_TDATA") sends = true;
        if (sends) send(client.GetPointer(), frame_of(served));
    }
    return 0;
}

}  // namespace

int main(int count, char** given) {
    std::signal(SIGPIPE, SIG_IGN);
    const Words words(given + 1, given + count);
    try {
        if (words.size() >= 4 && words[0] == "read") return read_all(words);
        if (words.size() >= 4 && words[0] == "serve") return serve(words);
        throw std::runtime_error("the words are in the head of tests/fakes/openigtlink_peer.cpp");
    } catch (const std::exception& error) {
        print_line("\"type\":\"error\",\"text\":" + quoted(error.what()));
        return 1;
    }
}
