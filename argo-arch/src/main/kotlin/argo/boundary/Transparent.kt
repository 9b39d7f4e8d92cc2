package argo.boundary

/**
 * An architecture that passes on every input of its agent unchanged. An agent can be recorded if all its architectures are transparent,
 * except `argo.Arch`.
 */
interface Transparent
