// SPDX-License-Identifier: BSD-3-Clause
#version 150
#extension GL_ARB_tessellation_shader : require
