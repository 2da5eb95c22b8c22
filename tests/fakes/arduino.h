// SPDX-License-Identifier: Apache-2.0
// As much of the Arduino library as docs/trainer/trainer.ino uses: a board whose inputs a test sets and whose
// serial port it reads.
#pragma once

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>

namespace fulcrum::test::arduino {

enum Pins : int { A0 = 14, A1, A2, A3, A4, A5, A6, A7, A8, A9, pin_count };
enum Levels : int { LOW, HIGH };
enum Modes : int { INPUT, OUTPUT, INPUT_PULLUP };

struct Board {
    int analog[pin_count] = {};
    int digital[pin_count] = {};
    int mode[pin_count] = {};
    std::uint32_t micros = 0;
    long baud = 0;
    std::string sent, to_read;
};
inline Board board;

struct SerialPort {
    void begin(long baud) { board.baud = baud; }
    int available() { return static_cast<int>(board.to_read.size()); }
    int read() {
        const int byte = static_cast<unsigned char>(board.to_read.front());
        board.to_read.erase(0, 1);
        return byte;
    }
    void print(const char* text) { board.sent += text; }
};
inline SerialPort Serial;

inline int analogRead(int pin) {
    return board.analog[pin];
}
inline int digitalRead(int pin) {
    return board.digital[pin];
}
inline void pinMode(int pin, int mode) {
    board.mode[pin] = mode;
    if (mode == INPUT_PULLUP) board.digital[pin] = HIGH;
}
inline unsigned long micros() {
    return board.micros;
}

}  // namespace fulcrum::test::arduino
