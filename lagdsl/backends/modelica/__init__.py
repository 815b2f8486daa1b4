"""The backend of Modelica."""
