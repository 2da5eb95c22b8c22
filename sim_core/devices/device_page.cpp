// SPDX-License-Identifier: Apache-2.0
#include "sim_core/devices/device_page.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <new>
#include <stdexcept>
#include <system_error>

#ifndef F_SEAL_FUTURE_WRITE
#define F_SEAL_FUTURE_WRITE 0x0010  // Linux 5.1
#endif

#include "sim_core/numerics/worded_error.h"

namespace fulcrum {
namespace {

[[noreturn]] void refuse(const char* what) {
    throw std::system_error(errno, std::generic_category(), what);
}

// Without the first two, another process could cut the memory off and end this one with SIGBUS.
constexpr int size_seals = F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_SEAL;

}  // namespace

const char* words_of(ForceOff why) {
    switch (why) {
        case ForceOff::none:
            return "force is rendered";
        case ForceOff::starting:
            return "waiting for steady commands";
        case ForceOff::no_program:
            return "no program is connected";
        case ForceOff::silent:
            return "the program sends no new force";
        case ForceOff::not_finite:
            return "the program sent a force that is not a number";
        case ForceOff::too_large:
            return "the program sent a force above the device's limit";
        case ForceOff::sequence_back:
            return "the program sent an old force again";
        case ForceOff::overseer_stopped:
            return "the process that guards the motors does not run";
        case ForceOff::device_stopped:
            return "the process that reads the device stopped or ended";
        case ForceOff::device_fault:
            return "the device has a fault";
    }
    return "";
}

std::int64_t monotonic_ns() noexcept {
    timespec time{};
    clock_gettime(CLOCK_MONOTONIC, &time);
    return time.tv_sec * 1000000000LL + time.tv_nsec;
}

template <typename T>
SharedPage<T> SharedPage<T>::create(const char* name, bool others_read) {
    SharedPage made;
    made.descriptor_ = memfd_create(name, MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (made.descriptor_ < 0) refuse("shared memory");
    if (ftruncate(made.descriptor_, sizeof(T)) != 0) refuse("shared memory: size");
    void* const memory = mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED, made.descriptor_, 0);
    if (memory == MAP_FAILED) refuse("shared memory: map");
    made.page_ = new (memory) T;
    const int seals = size_seals | (others_read ? F_SEAL_FUTURE_WRITE : 0);
    if (fcntl(made.descriptor_, F_ADD_SEALS, seals) != 0) refuse("shared memory: seals");
    return made;
}

template <typename T>
SharedPage<T> SharedPage<T>::open(int descriptor, bool writes) {
    SharedPage made;
    made.descriptor_ = descriptor;
    struct stat status {};
    const int seals = fcntl(descriptor, F_GET_SEALS);
    if (fstat(descriptor, &status) != 0 || status.st_size != static_cast<off_t>(sizeof(T)) || seals < 0 ||
        (seals & size_seals) != size_seals)
        throw WordedError(QT_TRANSLATE_NOOP("errors", "fulcrum-hapticd is of another version than fulcrum"));
    void* const memory =
        mmap(nullptr, sizeof(T), writes ? PROT_READ | PROT_WRITE : PROT_READ, MAP_SHARED, descriptor, 0);
    if (memory == MAP_FAILED) refuse("shared memory: map");
    made.page_ = static_cast<T*>(memory);
    return made;
}

template <typename T>
SharedPage<T>::~SharedPage() {
    if (page_ != nullptr) munmap(static_cast<void*>(page_), sizeof(T));
    if (descriptor_ >= 0) close(descriptor_);
}

template class SharedPage<StatePage>;
template class SharedPage<CommandPage>;

}  // namespace fulcrum
