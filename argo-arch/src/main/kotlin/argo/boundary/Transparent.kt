package argo.boundary

/** An architecture that hands on every input of its agent unchanged. Agents with such architectures besides `argo.Arch` can be recorded. */
interface Transparent
