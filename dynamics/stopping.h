#pragma once

// How far a vehicle runs before it stands, and how fast it may go to stop in time.
//
// The law behind it: told to stop, the regulator asks for the deceleration k V, no more than a. `k`
// is the velocity gain [1/s] (kp/kd of the regulator pd_rate), `a` the largest deceleration
// [m/s^2] (g tan(max tilt) for the quadrotor). All speeds and distances are along one line, >= 0.
namespace voronaut {

// The law by which a vehicle under a regulator stops: what the functions below take.
struct StoppingLaw {
  double k_1_s;   // deceleration per speed, when slow
  double a_m_s2;  // and its bound
};

// Distance run from speed V until rest: V/k while k V <= a, else V^2/(2a) + a/(2k^2) plus the time
// 0.1 s it takes to tilt, times the excess V - a/k. Fitted to the full quadrotor model: within 2.5
// % of it for the corrected inertia, up to 8 % short for the printed one, whose rotors saturate.
double stopping_distance_m(double speed_m_s, double k_1_s, double a_m_s2);

// Largest speed from which the vehicle, reacting after `reaction_time_s` (sensing, planning and
// transport delays), still stops `gamma_m` short of what is `free_distance_m` ahead: solves
// D(V) + V t_r = free - gamma. 0 if there is no room. Plan with a margin (10 %) on top.
double safe_speed_m_s(double free_distance_m, double gamma_m, double reaction_time_s, double k_1_s,
                      double a_m_s2);

}  // namespace voronaut
