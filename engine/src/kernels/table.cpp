#include "kernels.h"
#include "simd.h"

namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES {

FindOverlaps find_overlaps;
CollidePairs collide_boxes;
CollidePairs collide_discs;
CollidePairs collide_disc_with_box;
CollidePairs collide_box_with_disc;
MeasureAgain measure_again;
WeighContacts weigh_contacts;
KickByContacts kick_by_contacts;
PressContacts press_contacts;
RelaxContacts relax_contacts;
SettleOffsets settle_offsets;
KickByForces kick_by_forces;
KickBodies kick_bodies;
DriftBodies drift_bodies;
TurnToAngles turn_to_angles;

extern const Kernels table;
const Kernels table{find_overlaps,  collide_boxes,  collide_discs,    collide_disc_with_box, collide_box_with_disc,
                    measure_again,  weigh_contacts, kick_by_contacts, press_contacts,        relax_contacts,
                    settle_offsets, kick_by_forces, kick_bodies,      drift_bodies,          turn_to_angles};

}  // namespace impulse::inline IMPULSE_PRECISION::IMPULSE_LANES
