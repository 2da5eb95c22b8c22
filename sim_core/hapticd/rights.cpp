// SPDX-License-Identifier: Apache-2.0
#include "sim_core/hapticd/rights.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstddef>
#include <cstring>

namespace fulcrum::hapticd {
namespace {

#if defined(__x86_64__)
constexpr unsigned int own_architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr unsigned int own_architecture = AUDIT_ARCH_AARCH64;
#else
constexpr unsigned int own_architecture = 0;
#endif

constexpr long refused_calls[] = {SYS_socket,  SYS_socketpair, SYS_connect,           SYS_bind,
                                  SYS_listen,  SYS_execve,     SYS_execveat,          SYS_ptrace,
                                  SYS_mount,   SYS_bpf,        SYS_process_vm_writev, SYS_setns,
                                  SYS_unshare,
#if defined(SYS_fork)
                                  SYS_fork,    SYS_vfork
#endif
};

constexpr sock_filter statement(unsigned int code, unsigned int value) {
    return {static_cast<unsigned short>(code), 0, 0, value};
}
constexpr sock_filter jump_unless_equal(unsigned int value, unsigned char skip) {
    return {BPF_JMP | BPF_JEQ | BPF_K, 0, skip, value};
}

}  // namespace

RealTime become_real_time(int priority) {
    RealTime got;
    sched_param parameter{};
    parameter.sched_priority = priority;
    got.priority = sched_setscheduler(0, SCHED_FIFO, &parameter) == 0;
    if (!got.priority)
        got.notes.emplace_back(std::string("no real-time priority (") + std::strerror(errno) +
                               "): add '@audio - rtprio 95' to /etc/security/limits.d/fulcrum.conf, join "
                               "that group and sign in again");
    got.memory = mlockall(MCL_CURRENT | MCL_FUTURE) == 0;
    if (!got.memory)
        got.notes.emplace_back(std::string("memory can be paged out (") + std::strerror(errno) +
                               "): add '@audio - memlock unlimited' to /etc/security/limits.d/fulcrum.conf, "
                               "join that group and sign in again");
    return got;
}

bool give_up_rights() {
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || own_architecture == 0) return false;
    std::vector<sock_filter> filter;
    const auto load = [&filter](std::size_t offset) {
        filter.push_back(statement(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned int>(offset)));
    };
    const auto answer = [&filter](unsigned int value) {
        filter.push_back(statement(BPF_RET | BPF_K, value));
    };
    load(offsetof(seccomp_data, arch));
    filter.push_back({BPF_JMP | BPF_JEQ | BPF_K, 1, 0, own_architecture});
    answer(SECCOMP_RET_KILL_PROCESS);
    load(offsetof(seccomp_data, nr));
    for (const long call : refused_calls) {
        filter.push_back(jump_unless_equal(static_cast<unsigned int>(call), 1));
        answer(SECCOMP_RET_ERRNO | EPERM);
    }
    // Threads only; without clone3 the C library uses clone, whose flags a filter can read.
    filter.push_back(jump_unless_equal(static_cast<unsigned int>(SYS_clone3), 1));
    answer(SECCOMP_RET_ERRNO | ENOSYS);
    filter.push_back(jump_unless_equal(static_cast<unsigned int>(SYS_clone), 3));
    load(offsetof(seccomp_data, args[0]));
    filter.push_back({BPF_JMP | BPF_JSET | BPF_K, 1, 0, CLONE_THREAD});
    answer(SECCOMP_RET_ERRNO | EPERM);
    answer(SECCOMP_RET_ALLOW);
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    // The threads of a maker's library as well, where none has a filter of its own.
    if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, SECCOMP_FILTER_FLAG_TSYNC, &program) == 0) return true;
    return prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program, 0, 0) == 0;
}

}  // namespace fulcrum::hapticd
