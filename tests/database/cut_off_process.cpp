// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/database/cut_off_process.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QDir>
#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <stdexcept>
#include <system_error>

namespace fulcrum::database::test {
namespace {

const std::map<std::uint64_t, const char*>& changing_calls() {
    static const std::map<std::uint64_t, const char*> calls = {
        {SYS_write, "write"},         {SYS_pwrite64, "pwrite"},     {SYS_writev, "writev"},
        {SYS_ftruncate, "ftruncate"}, {SYS_renameat2, "renameat2"}, {SYS_unlinkat, "unlinkat"},
        {SYS_linkat, "linkat"},       {SYS_fchmod, "fchmod"},       {SYS_fallocate, "fallocate"},
        {SYS_mkdirat, "mkdirat"},     {SYS_openat, "open"},         {SYS_copy_file_range, "copy_file_range"},
#ifdef SYS_rename
        {SYS_rename, "rename"},       {SYS_unlink, "unlink"},       {SYS_link, "link"},
        {SYS_mkdir, "mkdir"},         {SYS_open, "open"},           {SYS_chmod, "chmod"},
#endif
#ifdef SYS_renameat
        {SYS_renameat, "renameat"},
#endif
    };
    return calls;
}

/// The call that the stopped child is about to make, if it changes a file; else null.
const char* changing_call(pid_t child) {
    __ptrace_syscall_info info{};
    if (::ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof info, &info) <= 0) return nullptr;
    if (info.op != PTRACE_SYSCALL_INFO_ENTRY) return nullptr;
    const auto found = changing_calls().find(info.entry.nr);
    if (found == changing_calls().end()) return nullptr;
    std::uint64_t flags = O_CREAT;
    if (info.entry.nr == SYS_openat) flags = info.entry.args[2];
#ifdef SYS_open
    if (info.entry.nr == SYS_open) flags = info.entry.args[1];
#endif
    return (flags & (O_CREAT | O_TRUNC)) != 0 ? found->second : nullptr;
}

pid_t start_traced(const std::function<void()>& deed) {
    std::fflush(nullptr);
    const pid_t child = ::fork();
    if (child < 0) throw std::system_error(errno, std::generic_category(), "fork");
    if (child == 0) {
        if (::ptrace(PTRACE_TRACEME, 0, nullptr, nullptr) != 0) ::_exit(2);
        ::raise(SIGSTOP);
        try {
            deed();
        } catch (const std::exception& error) {
            std::fprintf(stderr, "the deed failed: %s\n", error.what());
            ::_exit(1);
        }
        ::_exit(0);
    }
    int status = 0;
    if (::waitpid(child, &status, 0) != child || !WIFSTOPPED(status)) return -1;
    const auto options = reinterpret_cast<void*>(std::uintptr_t{PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL});
    if (::ptrace(PTRACE_SETOPTIONS, child, nullptr, options) != 0) {
        ::kill(child, SIGKILL);
        ::waitpid(child, &status, 0);
        return -1;
    }
    return child;
}

}  // namespace

bool can_trace() {
    static const bool can = [] {
        const pid_t child = start_traced([] {});
        if (child < 0) return false;
        ::kill(child, SIGKILL);
        int status = 0;
        ::waitpid(child, &status, 0);
        return true;
    }();
    return can;
}

CutOff cut_off(int number, const std::function<void()>& deed) {
    const pid_t child = start_traced(deed);
    if (child < 0) throw std::runtime_error("this machine forbids to trace a child");
    CutOff result;
    long signal_to_pass = 0;
    while (true) {
        int status = 0;
        ::ptrace(PTRACE_SYSCALL, child, nullptr, signal_to_pass);
        signal_to_pass = 0;
        if (::waitpid(child, &status, 0) != child) throw std::runtime_error("the traced child is lost");
        if (WIFEXITED(status) || WIFSIGNALED(status)) {
            result.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
            return result;
        }
        if (WSTOPSIG(status) != (SIGTRAP | 0x80)) {
            signal_to_pass = WSTOPSIG(status);
            continue;
        }
        const char* call = changing_call(child);
        if (call == nullptr) continue;
        if (++result.changes != number) continue;
        ::kill(child, SIGKILL);
        while (::waitpid(child, &status, 0) == child && !WIFEXITED(status) && !WIFSIGNALED(status)) {
        }
        result.killed = true;
        result.call = call;
        --result.changes;
        return result;
    }
}

TemporaryFoldersInMemory::TemporaryFoldersInMemory() : before_(QDir::tempPath().toStdString()) {
    if (::access("/dev/shm", W_OK | X_OK) == 0) qputenv("TMPDIR", "/dev/shm");
}
TemporaryFoldersInMemory::~TemporaryFoldersInMemory() {
    qputenv("TMPDIR", QByteArray::fromStdString(before_));
}

std::vector<int> cut_off_points(int all, int few) {
    std::vector<int> points;
    if (std::getenv("FULCRUM_CUT_OFF") != nullptr || all <= few) {
        for (int point = 1; point <= all; ++point) points.push_back(point);
        return points;
    }
    for (int k = 0; k < few; ++k) points.push_back(1 + (all - 1) * k / std::max(1, few - 1));
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace fulcrum::database::test
