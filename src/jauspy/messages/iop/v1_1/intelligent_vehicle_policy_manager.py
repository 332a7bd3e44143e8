"""urn:jaus:jss:iop:IntelligentVehiclePolicyManager 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from enum import IntEnum
from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:IntelligentVehiclePolicyManager", "1.1")


@jd.message(_SERVICE, 0xDDD5)
class ReportIntelligentVehicleCapabilities(jd.Message):
    """ReportIntelligentVehicleCapabilities (0xDDD5): Tells which assistance functions the platform has; how each works is left open.

    supported_behaviors: Functions the platform has
    """

    @jd.bit_field("Q")
    class SupportedBehaviors(jd.Struct):
        """Functions the platform has.

        obstacle_avoidance_behavior_stop: bit 0. Obstacle avoidance behavior stop.
        obstacle_avoidance_behavior_deviate_around_obstacle: bit 1. Obstacle avoidance behavior deviate around obstacle.
        pitchover_limit: bit 2. Pitchover limit.
        pitchover_warning: bit 3. Pitchover warning.
        rollover_limit: bit 4. Rollover limit.
        rollover_warning: bit 5. Rollover warning.
        antilock_brake_system: bit 6. Antilock brake system.
        traction_control: bit 7. Traction control.
        differential_lock: bit 8. Differential lock.
        front_suspension_lock: bit 9. Front suspension lock.
        rear_suspension_lock: bit 10. Rear suspension lock.
        active_pitchover_control: bit 11. Active pitchover control.
        active_rollover_control: bit 12. Active rollover control.
        forward_collision_warning: bit 13. Forward collision warning.
        blind_spot_monitoring: bit 14. Blind spot monitoring.
        lane_departure_warning: bit 15. Lane departure warning.
        pedestrian_detection_warning: bit 16. Pedestrian detection warning.
        backup_warning: bit 17. Backup warning.
        collision_mitigation_braking: bit 18. Collision mitigation braking.
        cross_traffic_assist: bit 19. Cross traffic assist.
        cross_traffic_warning: bit 20. Cross traffic warning.
        backup_assist: bit 21. Backup assist.
        lane_change_assist: bit 22. Lane change assist.
        lane_keeping_assist: bit 23. Lane keeping assist.
        adaptive_cruise_control: bit 24. Adaptive cruise control.
        emergency_braking_assist: bit 25. Emergency braking assist.
        hill_hold_control: bit 26. Hill hold control.
        hill_descent_control: bit 27. Hill descent control.
        automatic_lane_centering: bit 28. Automatic lane centering.
        automated_parking: bit 29. Automated parking.
        driver_attention_warning: bit 30. Driver attention warning.
        headway_warning: bit 31. Headway warning.
        reserved_for_iop: bits 32..49. Sent as 0, ignored when received.
        reserved_for_program_specific_use: bits 50..63. Sent as 0, ignored when received.
        """
        obstacle_avoidance_behavior_stop: int = jd.bits(0, 0x1)
        obstacle_avoidance_behavior_deviate_around_obstacle: int = jd.bits(1, 0x1)
        pitchover_limit: int = jd.bits(2, 0x1)
        pitchover_warning: int = jd.bits(3, 0x1)
        rollover_limit: int = jd.bits(4, 0x1)
        rollover_warning: int = jd.bits(5, 0x1)
        antilock_brake_system: int = jd.bits(6, 0x1)
        traction_control: int = jd.bits(7, 0x1)
        differential_lock: int = jd.bits(8, 0x1)
        front_suspension_lock: int = jd.bits(9, 0x1)
        rear_suspension_lock: int = jd.bits(10, 0x1)
        active_pitchover_control: int = jd.bits(11, 0x1)
        active_rollover_control: int = jd.bits(12, 0x1)
        forward_collision_warning: int = jd.bits(13, 0x1)
        blind_spot_monitoring: int = jd.bits(14, 0x1)
        lane_departure_warning: int = jd.bits(15, 0x1)
        pedestrian_detection_warning: int = jd.bits(16, 0x1)
        backup_warning: int = jd.bits(17, 0x1)
        collision_mitigation_braking: int = jd.bits(18, 0x1)
        cross_traffic_assist: int = jd.bits(19, 0x1)
        cross_traffic_warning: int = jd.bits(20, 0x1)
        backup_assist: int = jd.bits(21, 0x1)
        lane_change_assist: int = jd.bits(22, 0x1)
        lane_keeping_assist: int = jd.bits(23, 0x1)
        adaptive_cruise_control: int = jd.bits(24, 0x1)
        emergency_braking_assist: int = jd.bits(25, 0x1)
        hill_hold_control: int = jd.bits(26, 0x1)
        hill_descent_control: int = jd.bits(27, 0x1)
        automatic_lane_centering: int = jd.bits(28, 0x1)
        automated_parking: int = jd.bits(29, 0x1)
        driver_attention_warning: int = jd.bits(30, 0x1)
        headway_warning: int = jd.bits(31, 0x1)
        reserved_for_iop: int = jd.bits(32, 0x3FFFF, jd.Values(None, ((0, 262143),)))
        reserved_for_program_specific_use: int = jd.bits(50, 0x3FFF, jd.Values(None, ((0, 16383),)))

    supported_behaviors: ReportIntelligentVehicleCapabilities.SupportedBehaviors = jd.field("SupportedBehaviors", lambda: ReportIntelligentVehicleCapabilities.SupportedBehaviors.layout())


@jd.message(_SERVICE, 0xDDD1, query=True)
class QueryIntelligentVehicleCapabilities(jd.Message):
    """QueryIntelligentVehicleCapabilities (0xDDD1): Asks which assistance functions the platform has."""
    REPORT = ReportIntelligentVehicleCapabilities


@jd.message(_SERVICE, 0xDDD6, presence="H")
class ReportIntelligentVehicleConfiguration(jd.Message):
    """ReportIntelligentVehicleConfiguration (0xDDD6): Tells which functions are switched on and with which limits.

    obstacle_avoidance_stop_rec: optional
    obstacle_avoidance_deviate_rec: optional
    forward_collision_warning_rec: optional
    lane_depature_warning_rec: optional
    pedestrian_detection_warning_rec: optional
    backup_warning_rec: optional
    collision_mitigation_braking_rec: optional
    backup_assist_rec: optional
    lane_keeping_assist_rec: optional
    adaptive_cruise_control_rec: optional. Adaptive cruise control
    automated_parking_rec: optional
    """

    class ObstacleAvoidanceBehavior(IntEnum):
        DO_NOTHING = 0
        STOP = 1
        DEVIATE = 2

    @jd.bit_field("Q")
    class EnabledBehaviors(jd.Struct):
        """Behaviours that are switched on.

        obstacle_avoidance_behavior: bits 0..1. Obstacle avoidance behavior.
        pitchover_limit: bit 2. Pitchover limit.
        pitchover_warning: bit 3. Pitchover warning.
        rollover_limit: bit 4. Rollover limit.
        rollover_warning: bit 5. Rollover warning.
        antilock_brake_system: bit 6. Antilock brake system.
        traction_control: bit 7. Traction control.
        differential_lock: bit 8. Differential lock.
        front_suspension_lock: bit 9. Front suspension lock.
        rear_suspension_lock: bit 10. Rear suspension lock.
        active_pitchover_control: bit 11. Active pitchover control.
        active_rollover_control: bit 12. Active rollover control.
        forward_collision_warning: bit 13. Forward collision warning.
        blind_spot_monitoring: bit 14. Blind spot monitoring.
        lane_departure_warning: bit 15. Lane departure warning.
        pedestrian_detection_warning: bit 16. Pedestrian detection warning.
        backup_warning: bit 17. Backup warning.
        collision_mitigation_braking: bit 18. Collision mitigation braking.
        cross_traffic_assist: bit 19. Cross traffic assist.
        cross_traffic_warning: bit 20. Cross traffic warning.
        backup_assist: bit 21. Backup assist.
        lane_change_assist: bit 22. Lane change assist.
        lane_keeping_assist: bit 23. Lane keeping assist.
        adaptive_cruise_control: bit 24. Adaptive cruise control.
        emergency_braking_assist: bit 25. Emergency braking assist.
        hill_hold_control: bit 26. Hill hold control.
        hill_descent_control: bit 27. Hill descent control.
        automatic_lane_centering: bit 28. Automatic lane centering.
        automated_parking: bit 29. Automated parking.
        driver_attention_warning: bit 30. Driver attention warning.
        headway_warning: bit 31. Headway warning.
        reserved_for_iop: bits 32..49. Sent as 0, ignored when received.
        reserved_for_program_specific_use: bits 50..63. Sent as 0, ignored when received.
        """
        obstacle_avoidance_behavior: ReportIntelligentVehicleConfiguration.ObstacleAvoidanceBehavior | int = jd.bits(0, 0x3, lambda: jd.Values(ReportIntelligentVehicleConfiguration.ObstacleAvoidanceBehavior))
        pitchover_limit: int = jd.bits(2, 0x1)
        pitchover_warning: int = jd.bits(3, 0x1)
        rollover_limit: int = jd.bits(4, 0x1)
        rollover_warning: int = jd.bits(5, 0x1)
        antilock_brake_system: int = jd.bits(6, 0x1)
        traction_control: int = jd.bits(7, 0x1)
        differential_lock: int = jd.bits(8, 0x1)
        front_suspension_lock: int = jd.bits(9, 0x1)
        rear_suspension_lock: int = jd.bits(10, 0x1)
        active_pitchover_control: int = jd.bits(11, 0x1)
        active_rollover_control: int = jd.bits(12, 0x1)
        forward_collision_warning: int = jd.bits(13, 0x1)
        blind_spot_monitoring: int = jd.bits(14, 0x1)
        lane_departure_warning: int = jd.bits(15, 0x1)
        pedestrian_detection_warning: int = jd.bits(16, 0x1)
        backup_warning: int = jd.bits(17, 0x1)
        collision_mitigation_braking: int = jd.bits(18, 0x1)
        cross_traffic_assist: int = jd.bits(19, 0x1)
        cross_traffic_warning: int = jd.bits(20, 0x1)
        backup_assist: int = jd.bits(21, 0x1)
        lane_change_assist: int = jd.bits(22, 0x1)
        lane_keeping_assist: int = jd.bits(23, 0x1)
        adaptive_cruise_control: int = jd.bits(24, 0x1)
        emergency_braking_assist: int = jd.bits(25, 0x1)
        hill_hold_control: int = jd.bits(26, 0x1)
        hill_descent_control: int = jd.bits(27, 0x1)
        automatic_lane_centering: int = jd.bits(28, 0x1)
        automated_parking: int = jd.bits(29, 0x1)
        driver_attention_warning: int = jd.bits(30, 0x1)
        headway_warning: int = jd.bits(31, 0x1)
        reserved_for_iop: int = jd.bits(32, 0x3FFFF, jd.Values(None, ((0, 262143),)))
        reserved_for_program_specific_use: int = jd.bits(50, 0x3FFF, jd.Values(None, ((0, 16383),)))

    @jd.record()
    class IntelligentVehicleRec(jd.Struct):
        """enabled_behaviors: Behaviours that are switched on"""
        enabled_behaviors: ReportIntelligentVehicleConfiguration.EnabledBehaviors = jd.field("EnabledBehaviors", lambda: ReportIntelligentVehicleConfiguration.EnabledBehaviors.layout())

    @jd.record()
    class ObstacleAvoidanceStopRec(jd.Struct):
        """standoff_distance: Gap to keep to an obstacle when stopping before it"""
        standoff_distance: float = jd.field("StandoffDistance", jd.Number("f"))

    @jd.record()
    class ObstacleAvoidanceDeviateRec(jd.Struct):
        """path_tolerance: How far the vehicle may leave its path to pass an obstacle"""
        path_tolerance: float = jd.field("PathTolerance", jd.Number("f"))

    @jd.record()
    class ForwardCollisionWarningRec(jd.Struct):
        """trigger_forward_collision_seconds: Predicted time to impact below which the warning is raised"""
        trigger_forward_collision_seconds: float = jd.field("TriggerForwardCollisionSeconds", jd.Number("f"))

    @jd.record()
    class LaneDepatureWarningRec(jd.Struct):
        """trigger_lane_departure_meters: How far across the lane edge the vehicle may go before the warning is raised"""
        trigger_lane_departure_meters: float = jd.field("TriggerLaneDepartureMeters", jd.Number("f"))

    class Sensitivity(IntEnum):
        LOW = 0
        MEDIUM = 1
        HIGH = 2

    @jd.record()
    class PedestrianDetectionWarningRec(jd.Struct):
        """sensitivity: Sensitivity. How readily the pedestrian warning is raised"""
        sensitivity: ReportIntelligentVehicleConfiguration.Sensitivity | int = jd.field("Sensitivity", lambda: jd.Number("B", jd.Values(ReportIntelligentVehicleConfiguration.Sensitivity)))

    @jd.record()
    class BackupWarningRec(jd.Struct):
        """trigger_backup_warning_meters: Remaining gap behind the vehicle below which the warning is raised"""
        trigger_backup_warning_meters: float = jd.field("TriggerBackupWarningMeters", jd.Number("f"))

    @jd.record()
    class CollisionMitigationBrakingRec(jd.Struct):
        """trigger_collision_mitigation_braking_seconds: Predicted time to impact below which the vehicle brakes by itself"""
        trigger_collision_mitigation_braking_seconds: float = jd.field("TriggerCollisionMitigationBrakingSeconds", jd.Number("f"))

    @jd.record()
    class BackupAssistRec(jd.Struct):
        """trigger_backup_braking_meters: Way driven backwards until the assistant takes part"""
        trigger_backup_braking_meters: float = jd.field("TriggerBackupBrakingMeters", jd.Number("f"))

    @jd.record()
    class LaneKeepingAssistRec(jd.Struct):
        """terminate_lane_departure_meters: How far out of the lane the vehicle may go until the assistant switches off"""
        terminate_lane_departure_meters: float = jd.field("TerminateLaneDepartureMeters", jd.Number("f"))

    @jd.record()
    class AdaptiveCruiseControlRec(jd.Struct):
        """Adaptive cruise control.

        adaptive_cruise_control_headway_settings: Smallest gap to keep to the vehicle in front
        adaptive_cruise_control_min_set_speed: Lowest speed that may be set
        """
        adaptive_cruise_control_headway_settings: float = jd.field("AdaptiveCruiseControlHeadwaySettings", jd.Number("f"))
        adaptive_cruise_control_min_set_speed: float = jd.field("AdaptiveCruiseControlMinSetSpeed", jd.Number("f"))

    @jd.record()
    class AutomatedParkingRec(jd.Struct):
        """standoff_distance: Smallest gap to keep to other vehicles when parking"""
        standoff_distance: float = jd.field("StandoffDistance", jd.Number("f"))

    intelligent_vehicle_rec: ReportIntelligentVehicleConfiguration.IntelligentVehicleRec = jd.field("IntelligentVehicleRec", lambda: ReportIntelligentVehicleConfiguration.IntelligentVehicleRec.layout())
    obstacle_avoidance_stop_rec: ReportIntelligentVehicleConfiguration.ObstacleAvoidanceStopRec | None = jd.field("ObstacleAvoidanceStopRec", lambda: ReportIntelligentVehicleConfiguration.ObstacleAvoidanceStopRec.layout(), default=None)
    obstacle_avoidance_deviate_rec: ReportIntelligentVehicleConfiguration.ObstacleAvoidanceDeviateRec | None = jd.field("ObstacleAvoidanceDeviateRec", lambda: ReportIntelligentVehicleConfiguration.ObstacleAvoidanceDeviateRec.layout(), default=None)
    forward_collision_warning_rec: ReportIntelligentVehicleConfiguration.ForwardCollisionWarningRec | None = jd.field("ForwardCollisionWarningRec", lambda: ReportIntelligentVehicleConfiguration.ForwardCollisionWarningRec.layout(), default=None)
    lane_depature_warning_rec: ReportIntelligentVehicleConfiguration.LaneDepatureWarningRec | None = jd.field("LaneDepatureWarningRec", lambda: ReportIntelligentVehicleConfiguration.LaneDepatureWarningRec.layout(), default=None)
    pedestrian_detection_warning_rec: ReportIntelligentVehicleConfiguration.PedestrianDetectionWarningRec | None = jd.field("PedestrianDetectionWarningRec", lambda: ReportIntelligentVehicleConfiguration.PedestrianDetectionWarningRec.layout(), default=None)
    backup_warning_rec: ReportIntelligentVehicleConfiguration.BackupWarningRec | None = jd.field("BackupWarningRec", lambda: ReportIntelligentVehicleConfiguration.BackupWarningRec.layout(), default=None)
    collision_mitigation_braking_rec: ReportIntelligentVehicleConfiguration.CollisionMitigationBrakingRec | None = jd.field("CollisionMitigationBrakingRec", lambda: ReportIntelligentVehicleConfiguration.CollisionMitigationBrakingRec.layout(), default=None)
    backup_assist_rec: ReportIntelligentVehicleConfiguration.BackupAssistRec | None = jd.field("BackupAssistRec", lambda: ReportIntelligentVehicleConfiguration.BackupAssistRec.layout(), default=None)
    lane_keeping_assist_rec: ReportIntelligentVehicleConfiguration.LaneKeepingAssistRec | None = jd.field("LaneKeepingAssistRec", lambda: ReportIntelligentVehicleConfiguration.LaneKeepingAssistRec.layout(), default=None)
    adaptive_cruise_control_rec: ReportIntelligentVehicleConfiguration.AdaptiveCruiseControlRec | None = jd.field("AdaptiveCruiseControlRec", lambda: ReportIntelligentVehicleConfiguration.AdaptiveCruiseControlRec.layout(), default=None)
    automated_parking_rec: ReportIntelligentVehicleConfiguration.AutomatedParkingRec | None = jd.field("AutomatedParkingRec", lambda: ReportIntelligentVehicleConfiguration.AutomatedParkingRec.layout(), default=None)
    reserved_presence: int = 0


@jd.message(_SERVICE, 0xDDD2, query=True)
class QueryIntelligentVehicleConfiguration(jd.Message):
    """QueryIntelligentVehicleConfiguration (0xDDD2): Asks which functions are switched on and with which limits."""
    REPORT = ReportIntelligentVehicleConfiguration


@jd.message(_SERVICE, 0xDDD7)
class ReportIntelligentVehicleStatus(jd.Message):
    """ReportIntelligentVehicleStatus (0xDDD7): Tells which functions act at present.

    behavior_status: Present state of each function
    """

    class ObstacleAvoidanceBehavior(IntEnum):
        NORMAL = 0
        STOPPED = 1
        DEVIATING = 2

    @jd.bit_field("Q")
    class BehaviorStatus(jd.Struct):
        """Present state of each function.

        obstacle_avoidance_behavior: bits 0..1. Obstacle avoidance behavior.
        pitchover_limit: bit 2. Pitchover limit.
        pitchover_warning: bit 3. Pitchover warning.
        rollover_limit: bit 4. Rollover limit.
        rollover_warning: bit 5. Rollover warning.
        antilock_brake_system: bit 6. Antilock brake system.
        traction_control: bit 7. Traction control.
        differential_lock: bit 8. Differential lock.
        front_suspension_lock: bit 9. Front suspension lock.
        rear_suspension_lock: bit 10. Rear suspension lock.
        active_pitchover_control: bit 11. Active pitchover control.
        active_rollover_control: bit 12. Active rollover control.
        forward_collision_warning: bit 13. Forward collision warning.
        blind_spot_monitoring: bit 14. Blind spot monitoring.
        lane_departure_warning: bit 15. Lane departure warning.
        pedestrian_detection_warning: bit 16. Pedestrian detection warning.
        backup_warning: bit 17. Backup warning.
        collision_mitigation_braking: bit 18. Collision mitigation braking.
        cross_traffic_assist: bit 19. Cross traffic assist.
        cross_traffic_warning: bit 20. Cross traffic warning.
        backup_assist: bit 21. Backup assist.
        lane_change_assist: bit 22. Lane change assist.
        lane_keeping_assist: bit 23. Lane keeping assist.
        adaptive_cruise_control: bit 24. Adaptive cruise control.
        emergency_braking_assist: bit 25. Emergency braking assist.
        hill_hold_control: bit 26. Hill hold control.
        hill_descent_control: bit 27. Hill descent control.
        automatic_lane_centering: bit 28. Automatic lane centering.
        automated_parking: bit 29. Automated parking.
        driver_attention_warning: bit 30. Driver attention warning.
        headway_warning: bit 31. Headway warning.
        reserved_for_iop: bits 32..49. Sent as 0, ignored when received.
        reserved_for_program_specific_use: bits 50..63. Sent as 0, ignored when received.
        """
        obstacle_avoidance_behavior: ReportIntelligentVehicleStatus.ObstacleAvoidanceBehavior | int = jd.bits(0, 0x3, lambda: jd.Values(ReportIntelligentVehicleStatus.ObstacleAvoidanceBehavior))
        pitchover_limit: int = jd.bits(2, 0x1)
        pitchover_warning: int = jd.bits(3, 0x1)
        rollover_limit: int = jd.bits(4, 0x1)
        rollover_warning: int = jd.bits(5, 0x1)
        antilock_brake_system: int = jd.bits(6, 0x1)
        traction_control: int = jd.bits(7, 0x1)
        differential_lock: int = jd.bits(8, 0x1)
        front_suspension_lock: int = jd.bits(9, 0x1)
        rear_suspension_lock: int = jd.bits(10, 0x1)
        active_pitchover_control: int = jd.bits(11, 0x1)
        active_rollover_control: int = jd.bits(12, 0x1)
        forward_collision_warning: int = jd.bits(13, 0x1)
        blind_spot_monitoring: int = jd.bits(14, 0x1)
        lane_departure_warning: int = jd.bits(15, 0x1)
        pedestrian_detection_warning: int = jd.bits(16, 0x1)
        backup_warning: int = jd.bits(17, 0x1)
        collision_mitigation_braking: int = jd.bits(18, 0x1)
        cross_traffic_assist: int = jd.bits(19, 0x1)
        cross_traffic_warning: int = jd.bits(20, 0x1)
        backup_assist: int = jd.bits(21, 0x1)
        lane_change_assist: int = jd.bits(22, 0x1)
        lane_keeping_assist: int = jd.bits(23, 0x1)
        adaptive_cruise_control: int = jd.bits(24, 0x1)
        emergency_braking_assist: int = jd.bits(25, 0x1)
        hill_hold_control: int = jd.bits(26, 0x1)
        hill_descent_control: int = jd.bits(27, 0x1)
        automatic_lane_centering: int = jd.bits(28, 0x1)
        automated_parking: int = jd.bits(29, 0x1)
        driver_attention_warning: int = jd.bits(30, 0x1)
        headway_warning: int = jd.bits(31, 0x1)
        reserved_for_iop: int = jd.bits(32, 0x3FFFF, jd.Values(None, ((0, 262143),)))
        reserved_for_program_specific_use: int = jd.bits(50, 0x3FFF, jd.Values(None, ((0, 16383),)))

    behavior_status: ReportIntelligentVehicleStatus.BehaviorStatus = jd.field("BehaviorStatus", lambda: ReportIntelligentVehicleStatus.BehaviorStatus.layout())


@jd.message(_SERVICE, 0xDDD3, query=True)
class QueryIntelligentVehicleStatus(jd.Message):
    """QueryIntelligentVehicleStatus (0xDDD3): Asks which functions act at present."""
    REPORT = ReportIntelligentVehicleStatus


@jd.message(_SERVICE, 0xDDD4, presence="H", command=True)
class SetIntelligentVehicleConfiguration(jd.Message):
    """SetIntelligentVehicleConfiguration (0xDDD4): Switches functions on or off; may go unheeded if a function is not supported.

    obstacle_avoidance_stop_rec: optional
    obstacle_avoidance_deviate_rec: optional
    forward_collision_warning_rec: optional
    lane_depature_warning_rec: optional
    pedestrian_detection_warning_rec: optional
    backup_warning_rec: optional
    collision_mitigation_braking_rec: optional
    backup_assist_rec: optional
    lane_keeping_assist_rec: optional
    adaptive_cruise_control_rec: optional. Adaptive cruise control
    automated_parking_rec: optional
    """

    class ObstacleAvoidanceBehavior(IntEnum):
        DO_NOTHING = 0
        STOP = 1
        DEVIATE = 2

    @jd.bit_field("Q")
    class EnabledBehaviors(jd.Struct):
        """Behaviours that are switched on.

        obstacle_avoidance_behavior: bits 0..1. Obstacle avoidance behavior.
        pitchover_limit: bit 2. Pitchover limit.
        pitchover_warning: bit 3. Pitchover warning.
        rollover_limit: bit 4. Rollover limit.
        rollover_warning: bit 5. Rollover warning.
        antilock_brake_system: bit 6. Antilock brake system.
        traction_control: bit 7. Traction control.
        differential_lock: bit 8. Differential lock.
        front_suspension_lock: bit 9. Front suspension lock.
        rear_suspension_lock: bit 10. Rear suspension lock.
        active_pitchover_control: bit 11. Active pitchover control.
        active_rollover_control: bit 12. Active rollover control.
        forward_collision_warning: bit 13. Forward collision warning.
        blind_spot_monitoring: bit 14. Blind spot monitoring.
        lane_departure_warning: bit 15. Lane departure warning.
        pedestrian_detection_warning: bit 16. Pedestrian detection warning.
        backup_warning: bit 17. Backup warning.
        collision_mitigation_braking: bit 18. Collision mitigation braking.
        cross_traffic_assist: bit 19. Cross traffic assist.
        cross_traffic_warning: bit 20. Cross traffic warning.
        backup_assist: bit 21. Backup assist.
        lane_change_assist: bit 22. Lane change assist.
        lane_keeping_assist: bit 23. Lane keeping assist.
        adaptive_cruise_control: bit 24. Adaptive cruise control.
        emergency_braking_assist: bit 25. Emergency braking assist.
        hill_hold_control: bit 26. Hill hold control.
        hill_descent_control: bit 27. Hill descent control.
        automatic_lane_centering: bit 28. Automatic lane centering.
        automated_parking: bit 29. Automated parking.
        driver_attention_warning: bit 30. Driver attention warning.
        headway_warning: bit 31. Headway warning.
        reserved_for_iop: bits 32..49. Sent as 0, ignored when received.
        reserved_for_program_specific_use: bits 50..63. Sent as 0, ignored when received.
        """
        obstacle_avoidance_behavior: SetIntelligentVehicleConfiguration.ObstacleAvoidanceBehavior | int = jd.bits(0, 0x3, lambda: jd.Values(SetIntelligentVehicleConfiguration.ObstacleAvoidanceBehavior))
        pitchover_limit: int = jd.bits(2, 0x1)
        pitchover_warning: int = jd.bits(3, 0x1)
        rollover_limit: int = jd.bits(4, 0x1)
        rollover_warning: int = jd.bits(5, 0x1)
        antilock_brake_system: int = jd.bits(6, 0x1)
        traction_control: int = jd.bits(7, 0x1)
        differential_lock: int = jd.bits(8, 0x1)
        front_suspension_lock: int = jd.bits(9, 0x1)
        rear_suspension_lock: int = jd.bits(10, 0x1)
        active_pitchover_control: int = jd.bits(11, 0x1)
        active_rollover_control: int = jd.bits(12, 0x1)
        forward_collision_warning: int = jd.bits(13, 0x1)
        blind_spot_monitoring: int = jd.bits(14, 0x1)
        lane_departure_warning: int = jd.bits(15, 0x1)
        pedestrian_detection_warning: int = jd.bits(16, 0x1)
        backup_warning: int = jd.bits(17, 0x1)
        collision_mitigation_braking: int = jd.bits(18, 0x1)
        cross_traffic_assist: int = jd.bits(19, 0x1)
        cross_traffic_warning: int = jd.bits(20, 0x1)
        backup_assist: int = jd.bits(21, 0x1)
        lane_change_assist: int = jd.bits(22, 0x1)
        lane_keeping_assist: int = jd.bits(23, 0x1)
        adaptive_cruise_control: int = jd.bits(24, 0x1)
        emergency_braking_assist: int = jd.bits(25, 0x1)
        hill_hold_control: int = jd.bits(26, 0x1)
        hill_descent_control: int = jd.bits(27, 0x1)
        automatic_lane_centering: int = jd.bits(28, 0x1)
        automated_parking: int = jd.bits(29, 0x1)
        driver_attention_warning: int = jd.bits(30, 0x1)
        headway_warning: int = jd.bits(31, 0x1)
        reserved_for_iop: int = jd.bits(32, 0x3FFFF, jd.Values(None, ((0, 262143),)))
        reserved_for_program_specific_use: int = jd.bits(50, 0x3FFF, jd.Values(None, ((0, 16383),)))

    @jd.record()
    class IntelligentVehicleRec(jd.Struct):
        """enabled_behaviors: Behaviours that are switched on"""
        enabled_behaviors: SetIntelligentVehicleConfiguration.EnabledBehaviors = jd.field("EnabledBehaviors", lambda: SetIntelligentVehicleConfiguration.EnabledBehaviors.layout())

    @jd.record()
    class ObstacleAvoidanceStopRec(jd.Struct):
        """standoff_distance: Gap to keep to an obstacle when stopping before it"""
        standoff_distance: float = jd.field("StandoffDistance", jd.Number("f"))

    @jd.record()
    class ObstacleAvoidanceDeviateRec(jd.Struct):
        """path_tolerance: How far the vehicle may leave its path to pass an obstacle"""
        path_tolerance: float = jd.field("PathTolerance", jd.Number("f"))

    @jd.record()
    class ForwardCollisionWarningRec(jd.Struct):
        """trigger_forward_collision_seconds: Predicted time to impact below which the warning is raised"""
        trigger_forward_collision_seconds: float = jd.field("TriggerForwardCollisionSeconds", jd.Number("f"))

    @jd.record()
    class LaneDepatureWarningRec(jd.Struct):
        """trigger_lane_departure_meters: How far across the lane edge the vehicle may go before the warning is raised"""
        trigger_lane_departure_meters: float = jd.field("TriggerLaneDepartureMeters", jd.Number("f"))

    class Sensitivity(IntEnum):
        LOW = 0
        MEDIUM = 1
        HIGH = 2

    @jd.record()
    class PedestrianDetectionWarningRec(jd.Struct):
        """sensitivity: Sensitivity. How readily the pedestrian warning is raised"""
        sensitivity: SetIntelligentVehicleConfiguration.Sensitivity | int = jd.field("Sensitivity", lambda: jd.Number("B", jd.Values(SetIntelligentVehicleConfiguration.Sensitivity)))

    @jd.record()
    class BackupWarningRec(jd.Struct):
        """trigger_backup_warning_meters: Remaining gap behind the vehicle below which the warning is raised"""
        trigger_backup_warning_meters: float = jd.field("TriggerBackupWarningMeters", jd.Number("f"))

    @jd.record()
    class CollisionMitigationBrakingRec(jd.Struct):
        """trigger_collision_mitigation_braking_seconds: Predicted time to impact below which the vehicle brakes by itself"""
        trigger_collision_mitigation_braking_seconds: float = jd.field("TriggerCollisionMitigationBrakingSeconds", jd.Number("f"))

    @jd.record()
    class BackupAssistRec(jd.Struct):
        """trigger_backup_braking_meters: Way driven backwards until the assistant takes part"""
        trigger_backup_braking_meters: float = jd.field("TriggerBackupBrakingMeters", jd.Number("f"))

    @jd.record()
    class LaneKeepingAssistRec(jd.Struct):
        """terminate_lane_departure_meters: How far out of the lane the vehicle may go until the assistant switches off"""
        terminate_lane_departure_meters: float = jd.field("TerminateLaneDepartureMeters", jd.Number("f"))

    @jd.record()
    class AdaptiveCruiseControlRec(jd.Struct):
        """Adaptive cruise control.

        adaptive_cruise_control_headway_settings: Smallest gap to keep to the vehicle in front
        adaptive_cruise_control_min_set_speed: Lowest speed that may be set
        """
        adaptive_cruise_control_headway_settings: float = jd.field("AdaptiveCruiseControlHeadwaySettings", jd.Number("f"))
        adaptive_cruise_control_min_set_speed: float = jd.field("AdaptiveCruiseControlMinSetSpeed", jd.Number("f"))

    @jd.record()
    class AutomatedParkingRec(jd.Struct):
        """standoff_distance: Smallest gap to keep to other vehicles when parking"""
        standoff_distance: float = jd.field("StandoffDistance", jd.Number("f"))

    intelligent_vehicle_rec: SetIntelligentVehicleConfiguration.IntelligentVehicleRec = jd.field("IntelligentVehicleRec", lambda: SetIntelligentVehicleConfiguration.IntelligentVehicleRec.layout())
    obstacle_avoidance_stop_rec: SetIntelligentVehicleConfiguration.ObstacleAvoidanceStopRec | None = jd.field("ObstacleAvoidanceStopRec", lambda: SetIntelligentVehicleConfiguration.ObstacleAvoidanceStopRec.layout(), default=None)
    obstacle_avoidance_deviate_rec: SetIntelligentVehicleConfiguration.ObstacleAvoidanceDeviateRec | None = jd.field("ObstacleAvoidanceDeviateRec", lambda: SetIntelligentVehicleConfiguration.ObstacleAvoidanceDeviateRec.layout(), default=None)
    forward_collision_warning_rec: SetIntelligentVehicleConfiguration.ForwardCollisionWarningRec | None = jd.field("ForwardCollisionWarningRec", lambda: SetIntelligentVehicleConfiguration.ForwardCollisionWarningRec.layout(), default=None)
    lane_depature_warning_rec: SetIntelligentVehicleConfiguration.LaneDepatureWarningRec | None = jd.field("LaneDepatureWarningRec", lambda: SetIntelligentVehicleConfiguration.LaneDepatureWarningRec.layout(), default=None)
    pedestrian_detection_warning_rec: SetIntelligentVehicleConfiguration.PedestrianDetectionWarningRec | None = jd.field("PedestrianDetectionWarningRec", lambda: SetIntelligentVehicleConfiguration.PedestrianDetectionWarningRec.layout(), default=None)
    backup_warning_rec: SetIntelligentVehicleConfiguration.BackupWarningRec | None = jd.field("BackupWarningRec", lambda: SetIntelligentVehicleConfiguration.BackupWarningRec.layout(), default=None)
    collision_mitigation_braking_rec: SetIntelligentVehicleConfiguration.CollisionMitigationBrakingRec | None = jd.field("CollisionMitigationBrakingRec", lambda: SetIntelligentVehicleConfiguration.CollisionMitigationBrakingRec.layout(), default=None)
    backup_assist_rec: SetIntelligentVehicleConfiguration.BackupAssistRec | None = jd.field("BackupAssistRec", lambda: SetIntelligentVehicleConfiguration.BackupAssistRec.layout(), default=None)
    lane_keeping_assist_rec: SetIntelligentVehicleConfiguration.LaneKeepingAssistRec | None = jd.field("LaneKeepingAssistRec", lambda: SetIntelligentVehicleConfiguration.LaneKeepingAssistRec.layout(), default=None)
    adaptive_cruise_control_rec: SetIntelligentVehicleConfiguration.AdaptiveCruiseControlRec | None = jd.field("AdaptiveCruiseControlRec", lambda: SetIntelligentVehicleConfiguration.AdaptiveCruiseControlRec.layout(), default=None)
    automated_parking_rec: SetIntelligentVehicleConfiguration.AutomatedParkingRec | None = jd.field("AutomatedParkingRec", lambda: SetIntelligentVehicleConfiguration.AutomatedParkingRec.layout(), default=None)
    reserved_presence: int = 0
