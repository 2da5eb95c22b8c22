// SPDX-License-Identifier: Apache-2.0
// Of each program: ends it with one line if the processor lacks the instructions that it is built for
// (x86-64-v3). Compiled for the oldest x86-64, runs before all other initialisers of the program and calls
// only the C library, so that no code that needs those instructions runs before it.
#include <sys/platform/x86.h>
#include <unistd.h>

#include <cstring>

namespace {

void write_text(const char* text) {
    const ssize_t written = write(STDERR_FILENO, text, std::strlen(text));
    static_cast<void>(written);
}

const char* missing_instructions() {
    if (x86_cpu_active(x86_cpu_AVX2) == 0) return "AVX2";
    if (x86_cpu_active(x86_cpu_FMA) == 0) return "FMA";
    if (x86_cpu_active(x86_cpu_BMI1) == 0) return "BMI1";
    if (x86_cpu_active(x86_cpu_BMI2) == 0) return "BMI2";
    if (x86_cpu_active(x86_cpu_F16C) == 0) return "F16C";
    if (x86_cpu_active(x86_cpu_LZCNT) == 0) return "LZCNT";
    if (x86_cpu_active(x86_cpu_MOVBE) == 0) return "MOVBE";
    return nullptr;
}

__attribute__((constructor(101))) void check_processor() {
    const char* missing = missing_instructions();
    if (missing == nullptr) return;
    write_text("fulcrum: this processor has no ");
    write_text(missing);
    write_text(
        " instructions, which Fulcrum needs. Use an Intel processor from 2013 (Haswell) or later, or an AMD "
        "processor from 2015 (Excavator) or later.\n");
    _exit(2);
}

}  // namespace
