/* Top and release of the examples: those of host/scenarios/toy_top.toml. */
#ifndef RELEASE_H
#define RELEASE_H
#include "toytop.h"

static const toytop_top top = {
    TOYTOP_SLIDING, 3.0e-5 /* A, kg m^2 */, 2.0e-5 /* C, kg m^2 */, 0.03 /* s, m */, 0.05 /* M, kg */, 0.0, 9.81 /* m/s^2 */, 0.0
};

/* 20 degrees, as the scenario has them in rad; 150 rad/s about the axis. */
static const toytop_release release_at_20_degrees = {20.0 * 0.017453292519943295, 0.0, 0.0, 150.0, 0.0, 0.0};

/* A stroke of 2 mN s on the rim, 25 mm from the axis, at the height of the centre of mass. */
static const double impulse[3] = {0.0, 2.0e-3, 0.0}, point[3] = {0.025, 0.0, 0.03};
#endif
