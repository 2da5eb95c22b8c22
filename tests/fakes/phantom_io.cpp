// SPDX-License-Identifier: Apache-2.0
// The library that libHD_part.so needs and does not find.
extern "C" int phantom_io_version() {
    return 42;
}
