/* Gaps between the driver's circles and the wheel of a Geneva drive, for Siconos. geneva.py compiles this file and writes the outlines into `drive`.

   Coordinates q: angle of the wheel, angle of the driver. Each circle of the driver has a contact with the point of the wheel's outline that is nearest
   to its centre, of those in the directions in which the circle is outline. */
#include <math.h>

struct {
    double count, piece[64][8];   /* of the wheel: ends, centre, start and sweep of the arc; a sweep of 0 is a line */
    double circle[4][5], shaft;   /* of the driver: centre, radius, middle and half of the range of directions that is its outline */
} drive;

typedef unsigned U;

static void turned(double a, double x, double y, double *to) { to[0] = cos(a) * x - sin(a) * y, to[1] = sin(a) * x + cos(a) * y; }

/* The point of a piece that is nearest to p, apart from its ends; 0 if there is none, or if it is not nearer than `nearest`. */
static int foot(const double *e, const double *p, double nearest, double *at) {
    if (e[7] == 0) {
        double dx = e[2] - e[0], dy = e[3] - e[1], part = ((p[0] - e[0]) * dx + (p[1] - e[1]) * dy) / (dx * dx + dy * dy);
        at[0] = e[0] + part * dx, at[1] = e[1] + part * dy;
        return part > 0 && part < 1;
    }
    double x = p[0] - e[4], y = p[1] - e[5], away = hypot(x, y), radius = hypot(e[0] - e[4], e[1] - e[5]);
    if (away == 0 || fabs(away - radius) >= nearest) return 0;
    at[0] = e[4] + radius * x / away, at[1] = e[5] + radius * y / away;
    return fmod((atan2(y, x) - e[6]) * (e[7] > 0 ? 1 : -1) + 4 * M_PI, 2 * M_PI) < fabs(e[7]);
}

/* The gap of circle k, and the rates at which it opens as the parts turn. */
static double gap(int k, const double *q, double *g) {
    const double *c = drive.circle[k];
    double arm[2], p[2], nearest = 1e9, n[2] = {1, 0}, best[2] = {0, 0};
    turned(q[1], c[0], c[1], arm);
    turned(-q[0], drive.shaft + arm[0], arm[1], p);
    for (int i = 0; i < drive.count; i++)
        for (int which = 0; which < 2; which++) {
            double at[2] = {drive.piece[i][0], drive.piece[i][1]};
            if (which && !foot(drive.piece[i], p, nearest, at)) continue;
            double x = p[0] - at[0], y = p[1] - at[1], away = hypot(x, y);
            if (away >= nearest || fabs(remainder(atan2(-y, -x) + q[0] - q[1] - c[3], 2 * M_PI)) > c[4]) continue;
            nearest = away, best[0] = at[0], best[1] = at[1], n[0] = x / away, n[1] = y / away;
        }
    turned(q[0], n[0], n[1], n), turned(q[0], best[0], best[1], best);
    g[0] = n[0] * best[1] - n[1] * best[0], g[1] = n[1] * arm[0] - n[0] * arm[1];
    return nearest - c[2];
}

#define FOR_SICONOS(k)                                                                                              \
    void gap##k(U n, double *q, U ny, double *y, U nz, double *z) { double g[2]; y[0] = gap(k, q, g); }              \
    void rows##k(U n, double *q, U ny, double *g, U nz, double *z) { gap(k, q, g); }
FOR_SICONOS(0) FOR_SICONOS(1) FOR_SICONOS(2) FOR_SICONOS(3)
