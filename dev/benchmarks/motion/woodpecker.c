/* The equations of the woodpecker toy, and the time stepping of Moreau for them. woodpecker.py compiles this file, writes the numbers of the toy
   into `toy`, steps by `moreau`, and has Siconos call `masses`, `forces`, `gapK` and `rowsK` of contact K.

   Coordinates q: x and y of the sleeve's centre, angle of the sleeve, angle of the bird. Contacts 0 to 3 are the corners of the sleeve's bore, 4 is the
   beak. With `linear` the equations are Glocker's: linear in the angles, the sleeve's centre on the pole's axis, corners on the bird's side only. */
#include <math.h>

struct {
    double mass[2], inertia[2], arm, body, stiffness, gravity, pole, corner[4][2], beak[2], tip, friction[5], restitution[5], linear;
} toy;

typedef unsigned U;

void masses(U n, double *q, double *m, U nz, double *z) {
    double r = toy.arm, s = toy.body, *l = toy.mass, linear = toy.linear;
    double a[4] = {1, 0, linear ? 0 : -r * sin(q[2]), linear ? 0 : -s * sin(q[3])};
    double c[4] = {0, 1, linear ? r : r * cos(q[2]), linear ? s : s * cos(q[3])};
    for (int i = 0; i < 16; i++) m[i] = l[1] * (a[i / 4] * a[i % 4] + c[i / 4] * c[i % 4]);
    m[0] += linear ? 1e30 : l[0], m[5] += l[0], m[10] += toy.inertia[0], m[15] += toy.inertia[1];
}

/* The forces with a minus, on the left-hand side, as Siconos has them. */
void forces(double t, U n, double *q, double *v, double *f, U nz, double *z) {
    double b = toy.mass[1], turn = toy.linear ? 0 : 1, ca = cos(turn * q[2]), sa = sin(turn * q[2]), cb = cos(turn * q[3]), sb = sin(turn * q[3]);
    double wa = turn * toy.arm * v[2] * v[2], wb = turn * toy.body * v[3] * v[3];
    double fx = b * (wa * ca + wb * cb), fy = b * (wa * sa + wb * sb - toy.gravity), torque = toy.stiffness * (q[3] - q[2]);
    f[0] = -fx;
    f[1] = toy.mass[0] * toy.gravity - fy;
    f[2] = -toy.arm * (ca * fy - sa * fx) - torque;
    f[3] = -toy.body * (cb * fy - sb * fx) + torque;
}

/* The gap of contact k, and by columns the rates at which it opens and at which the part slides up the pole. */
static double contact(int k, const double *q, double *g) {
    const double *p = k < 4 ? toy.corner[k] : toy.beak;
    double side = p[0] < 0 && k < 4 ? -1 : 1, of = q[k < 4 ? 2 : 3], linear = toy.linear, c = linear ? 1 : cos(of), s = linear ? of : sin(of);
    double px = c * p[0] - s * p[1], x = linear ? p[0] : px, y = linear ? p[1] : s * p[0] + c * p[1]; /* x, y: the arm of the turn */
    double hinge = k < 4 ? 0 : toy.arm, cosine = linear ? 1 : cos(q[2]), sine = linear ? 0 : sin(q[2]), tip = k < 4 ? 0 : toy.tip;
    double all[8] = {side, 0, 0, 1, -hinge * sine, hinge * cosine, 0, 0};
    all[k < 4 ? 4 : 6] = -side * y, all[k < 4 ? 5 : 7] = x - tip;
    for (int i = 0; i < 8; i++) g[i] = all[i];
    return linear && side < 0 ? 1 : side * (q[0] + hinge * cosine + px) - tip - toy.pole;
}

#define FOR_SICONOS(k)                                                                                                    \
    void gap##k(U n, double *q, U ny, double *y, U nz, double *z) { double g[8]; y[0] = contact(k, q, g), y[1] = 0; }      \
    void rows##k(U n, double *q, U ny, double *g, U nz, double *z) { contact(k, q, g); }
FOR_SICONOS(0) FOR_SICONOS(1) FOR_SICONOS(2) FOR_SICONOS(3) FOR_SICONOS(4)

/* x = m⁻¹ b by the factor of Cholesky in the lower half of m. */
static void factor(double *m) {
    for (int j = 0; j < 4; j++)
        for (int i = j; i < 4; i++) {
            double sum = m[4 * i + j];
            for (int k = 0; k < j; k++) sum -= m[4 * i + k] * m[4 * j + k];
            m[4 * i + j] = i == j ? sqrt(sum) : sum / m[5 * j];
        }
}

static void solve(const double *m, const double *b, double *x) {
    for (int i = 0; i < 4; i++) {
        x[i] = b[i];
        for (int k = 0; k < i; k++) x[i] -= m[4 * i + k] * x[k];
        x[i] /= m[5 * i];
    }
    for (int i = 3; i >= 0; i--) {
        for (int k = i + 1; k < 4; k++) x[i] -= m[4 * k + i] * x[k];
        x[i] /= m[5 * i];
    }
}

static double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3]; }

/* Steps of length h from q, v. Writes the times at which the bird's angle falls through `level`, at most `room`, and says how many; -1 if impulses are
   not found. Half a step of rates; impulses p of what is closed there, one after another until no rate changes; another half a step. */
int moreau(double h, long steps, double level, double *q, double *v, double *times, int room) {
    double p[10] = {0}, m[16], f[4], x[4], g[8], row[10][4], way[10][4], aim[10];
    int found = 0;
    for (long k = 0; k < steps && found < room; k++) {
        double before = q[3], largest = 0;
        for (int i = 0; i < 4; i++) q[i] += h / 2 * v[i];
        masses(4, q, m, 0, 0), forces(0, 4, q, v, f, 0, 0), factor(m), solve(m, f, x);
        int closed[5], count = 0;
        for (int c = 0; c < 5; c++) {
            if (contact(c, q, g) > 0) {
                p[2 * c] = p[2 * c + 1] = 0;
                continue;
            }
            closed[count++] = c;
            for (int j = 2 * c; j < 2 * c + 2; j++) {
                double scale = 0;
                for (int i = 0; i < 4; i++) row[j][i] = g[2 * i + j % 2], scale += fabs(row[j][i]) * (fabs(v[i]) + h * fabs(x[i]));
                largest = fmax(largest, scale);
                solve(m, row[j], way[j]);
            }
            aim[2 * c] = toy.restitution[c] * fmin(dot(row[2 * c], v), 0), aim[2 * c + 1] = 0;
        }
        for (int i = 0; i < 4; i++) v[i] -= h * x[i];
        for (int c = 0; c < count; c++)
            for (int j = 2 * closed[c]; j < 2 * closed[c] + 2; j++)
                for (int i = 0; i < 4; i++) v[i] += way[j][i] * p[j];
        int rounds = 0;
        for (double change = 1; count && change > 1e-13 * largest; rounds++) {
            if (rounds > 100000) return -1;
            change = 0;
            for (int c = 0; c < count; c++)
                for (int j = 2 * closed[c]; j < 2 * closed[c] + 2; j++) {
                    double own = dot(row[j], way[j]), wanted = p[j] - (dot(row[j], v) + aim[j]) / own, most = toy.friction[closed[c]] * p[j - j % 2];
                    wanted = j % 2 ? fmax(-most, fmin(most, wanted)) : fmax(0, wanted);
                    for (int i = 0; i < 4; i++) v[i] += way[j][i] * (wanted - p[j]);
                    change = fmax(change, fabs(wanted - p[j]) * own), p[j] = wanted;
                }
        }
        for (int i = 0; i < 4; i++) q[i] += h / 2 * v[i];
        if (before > level && level >= q[3]) times[found++] = h * (k + (before - level) / (before - q[3]));
    }
    return found;
}
