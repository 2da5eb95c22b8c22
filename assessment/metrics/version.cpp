// SPDX-License-Identifier: Apache-2.0
#include "assessment/metrics/version.h"
