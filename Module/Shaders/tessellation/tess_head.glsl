// SPDX-License-Identifier: BSD-3-Clause
#version 150
#extension GL_ARB_tessellation_shader : require

const int WFV_INTERVALS = 8; // in which an edge is measured, a whole vec4 of them twice
