package argo.boundary

/**
 * An architecture that passes on every input of its agent unchanged. An agent can be recorded if each of its architectures is `argo.Arch`
 * or transparent.
 */
interface Transparent
