// SPDX-License-Identifier: Apache-2.0
// Sketch of a box trainer for Fulcrum (docs/TRAINER.md): reads the sensors of one or two instruments and
// sends where they are. For an Arduino Uno, Nano, Leonardo (one instrument) or Mega (two), and boards alike.
//
// Each sensor is a potentiometer between 5 V and ground with its middle pin on an analog input. A button
// connects its pin to ground. Set below what you have, and look at it with `fulcrum devices --test trainer`.

// A comma or a star is not allowed in the name; at most 32 letters.
const char trainer_name[] = "Box trainer";
#ifndef TWO_INSTRUMENTS
#define TWO_INSTRUMENTS 0  // 1: also the left one, for a board with ten analog inputs
#endif
const int instruments = TWO_INSTRUMENTS ? 2 : 1;
const long lines_rate = 80;   // a second for each instrument, 20 to 500; with two, 115200 bits hold no more
const long line_baud = 115200;

// What a sensor reads at the two ends of its range, and what that is. Angles are millionths of a radian,
// lengths micrometres: 30 degrees are 523599, 150 mm are 150000.
struct Sensor {
    int pin;
    long low_count, high_count;
    long low_value, high_value;
};
struct Instrument {
    char letter;        // L: left hand, R: right hand, S: scope
    Sensor pitch;       // the tip up is positive
    Sensor yaw;         // the tip to the right is positive
    Sensor insertion;   // from the pivot to the tip
    Sensor roll;        // clockwise, seen from the handle, is positive
    Sensor jaw;         // 0 closed, 1000 open
    int pedal_pin;      // energy
    int exchange_pin;   // next instrument
};
const Instrument instrument_table[] = {
    {'R',
     {A0, 0, 1023, -785398, 785398},
     {A1, 0, 1023, -785398, 785398},
     {A2, 0, 1023, 50000, 250000},
     {A3, 0, 1023, -3141593, 3141593},
     {A4, 0, 1023, 0, 1000},
     2,
     3},
#if TWO_INSTRUMENTS
    {'L',
     {A5, 0, 1023, -785398, 785398},
     {A6, 0, 1023, -785398, 785398},
     {A7, 0, 1023, 50000, 250000},
     {A8, 0, 1023, -3141593, 3141593},
     {A9, 0, 1023, 0, 1000},
     4,
     5},
#endif
};

bool asked = false;  // Fulcrum wants lines
unsigned int line_count = 0;
unsigned long last_frame_us = 0;
char received[16];
unsigned int received_length = 0;

// CRC-16/CCITT-FALSE.
unsigned int checksum_of(const char* text) {
    unsigned long sum = 0xFFFF;
    for (; *text != 0; ++text) {
        sum ^= (unsigned long)(unsigned char)*text << 8;
        for (int bit = 0; bit < 8; ++bit) sum = (sum & 0x8000UL) != 0 ? (sum << 1) ^ 0x1021UL : sum << 1;
        sum &= 0xFFFFUL;
    }
    return (unsigned int)sum;
}

void send_line(const char* body) {
    char end[8];
    snprintf(end, sizeof end, "*%04X\n", checksum_of(body));
    Serial.print(body);
    Serial.print(end);
}

void send_hello() {
    char body[64];
    snprintf(body, sizeof body, "F1,H,%s,%ld,%s", trainer_name, lines_rate, instruments == 2 ? "RL" : "R");
    send_line(body);
}

long value_of(const Sensor& sensor) {
    const long count = analogRead(sensor.pin);
    const long span = sensor.high_count - sensor.low_count;
    // In floating point: the product of two of these would not fit into a long.
    const double share = span == 0 ? 0.0 : (double)(count - sensor.low_count) / (double)span;
    const double value = (double)sensor.low_value + share * (double)(sensor.high_value - sensor.low_value);
    return (long)value;
}

long within(long value, long least, long most) {
    return value < least ? least : value > most ? most : value;
}

void send_pose(const Instrument& one, unsigned long now_us) {
    const int buttons =
        (digitalRead(one.pedal_pin) == LOW ? 4 : 0) | (digitalRead(one.exchange_pin) == LOW ? 8 : 0);
    char body[96];
    snprintf(body, sizeof body, "F1,P,%u,%lu,%c,%ld,%ld,%ld,%ld,%ld,%d", line_count & 0xFFFFU, now_us,
             one.letter, value_of(one.pitch), value_of(one.yaw), value_of(one.insertion), value_of(one.roll),
             within(value_of(one.jaw), 0, 1000), buttons);
    send_line(body);
}

// Fulcrum asks with "F1,?" and its checksum.
void listen() {
    while (Serial.available() > 0) {
        const char byte = (char)Serial.read();
        if (byte == '\n') {
            received[received_length] = 0;
            if (strcmp(received, "F1,?*BB67") == 0) {
                send_hello();
                asked = true;
            }
            received_length = 0;
        } else if (received_length + 1 < sizeof received) {
            received[received_length++] = byte;
        }
    }
}

void setup() {
    for (int i = 0; i < instruments; ++i) {
        pinMode(instrument_table[i].pedal_pin, INPUT_PULLUP);
        pinMode(instrument_table[i].exchange_pin, INPUT_PULLUP);
    }
    Serial.begin(line_baud);
}

void loop() {
    listen();
    const unsigned long now_us = micros();
    if (!asked || now_us - last_frame_us < 1000000UL / (unsigned long)lines_rate) return;
    last_frame_us = now_us;
    for (int i = 0; i < instruments; ++i) send_pose(instrument_table[i], now_us);
    ++line_count;
}
