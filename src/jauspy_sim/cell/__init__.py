"""The modular factory cell in MuJoCo: servo modules, vacuum connectors, conveyor, car."""
