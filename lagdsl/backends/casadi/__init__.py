"""The backend of CasADi."""
