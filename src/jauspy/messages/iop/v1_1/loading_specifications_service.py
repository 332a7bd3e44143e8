"""urn:jaus:jss:iop:LoadingSpecificationsService 1.1. Generated from schemas/; do not edit."""

from __future__ import annotations

from jauspy.codec import declare as jd

_SERVICE = jd.Service("urn:jaus:jss:iop:LoadingSpecificationsService", "1.1")


@jd.message(_SERVICE, 0xCB19)
class ReportLoadingSpecifications(jd.Message):
    """ReportLoadingSpecifications (0xCB19): Tells the data of the load.

    loading_specifications_rec_bit_field: What is attached to the vehicle
    vehicle_load: How heavy the load is
    load_height: Extent of the load in Z of the vehicle frame
    load_width: Extent of the load in Y of the vehicle frame
    load_length: Extent of the load in X of the vehicle frame
    load_center_x: X of the load's middle in the vehicle frame
    load_center_y: Y of the load's middle in the vehicle frame
    load_center_z: Z of the load's middle in the vehicle frame
    """

    @jd.bit_field("B")
    class LoadingSpecificationsRecBitField(jd.Struct):
        """What is attached to the vehicle.

        trailer_attached: bit 0. Trailer attached.
        roller_present: bit 1. Roller present.
        """
        trailer_attached: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        roller_present: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    loading_specifications_rec_bit_field: ReportLoadingSpecifications.LoadingSpecificationsRecBitField = jd.field("LoadingSpecificationsRecBitField", lambda: ReportLoadingSpecifications.LoadingSpecificationsRecBitField.layout())
    vehicle_load: float = jd.field("VehicleLoad", jd.Number("f"))
    load_height: float = jd.field("LoadHeight", jd.Number("f"))
    load_width: float = jd.field("LoadWidth", jd.Number("f"))
    load_length: float = jd.field("LoadLength", jd.Number("f"))
    load_center_x: float = jd.field("LoadCenterX", jd.Number("f"))
    load_center_y: float = jd.field("LoadCenterY", jd.Number("f"))
    load_center_z: float = jd.field("LoadCenterZ", jd.Number("f"))


@jd.message(_SERVICE, 0xCB20, query=True)
class QueryLoadingSpecifications(jd.Message):
    """QueryLoadingSpecifications (0xCB20): Asks for the data of the load."""
    REPORT = ReportLoadingSpecifications


@jd.message(_SERVICE, 0xCB18, command=True)
class SetLoadingSpecifications(jd.Message):
    """SetLoadingSpecifications (0xCB18): Sets the data of the load.

    loading_specifications_rec_bit_field: What is attached to the vehicle
    vehicle_load: How heavy the load is
    load_height: Extent of the load in Z of the vehicle frame
    load_width: Extent of the load in Y of the vehicle frame
    load_length: Extent of the load in X of the vehicle frame
    load_center_x: X of the load's middle in the vehicle frame
    load_center_y: Y of the load's middle in the vehicle frame
    load_center_z: Z of the load's middle in the vehicle frame
    """

    @jd.bit_field("B")
    class LoadingSpecificationsRecBitField(jd.Struct):
        """What is attached to the vehicle.

        trailer_attached: bit 0. Trailer attached.
        roller_present: bit 1. Roller present.
        """
        trailer_attached: int = jd.bits(0, 0x1, jd.Values(None, ((0, 1),)))
        roller_present: int = jd.bits(1, 0x1, jd.Values(None, ((0, 1),)))
        reserved_bits: int = 0

    loading_specifications_rec_bit_field: SetLoadingSpecifications.LoadingSpecificationsRecBitField = jd.field("LoadingSpecificationsRecBitField", lambda: SetLoadingSpecifications.LoadingSpecificationsRecBitField.layout())
    vehicle_load: float = jd.field("VehicleLoad", jd.Number("f"))
    load_height: float = jd.field("LoadHeight", jd.Number("f"))
    load_width: float = jd.field("LoadWidth", jd.Number("f"))
    load_length: float = jd.field("LoadLength", jd.Number("f"))
    load_center_x: float = jd.field("LoadCenterX", jd.Number("f"))
    load_center_y: float = jd.field("LoadCenterY", jd.Number("f"))
    load_center_z: float = jd.field("LoadCenterZ", jd.Number("f"))
