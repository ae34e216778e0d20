// SPDX-License-Identifier: GPL-3.0-or-later
// host.h: the MeshLab that the plugin is built for. The only place that asks which one it is.
#pragma once

#if DEVELOPABLE_HOST_YEAR == 2020
#include "hosts/meshlab_2020/host_api.h"
#else
#include "hosts/meshlab_2022/host_api.h"
#endif
