/** Packs the only jar that a Jason project needs for ARGO. The jar contains everything except Jason. */
val argoJar by tasks.registering(JavaExec::class) {
    description = "Packs argo.jar."
    val jar = layout.buildDirectory.file("libs/argo.jar")
    val packed = files(configurations.runtimeClasspath)
    val version = project.version.toString()
    inputs.files(packed)
    inputs.property("version", version)
    outputs.file(jar)
    classpath(sourceSets.main.map { it.output }, configurations.compileClasspath)
    mainClass = "argo.packing.MainKt"
    argumentProviders.add(CommandLineArgumentProvider { listOf(jar.get().asFile.path, version, packed.asPath) })
}

/** The class path of fleets: the content of `argo-fleet.jar` and of `argo.jar`. */
val fleets = configurations.create("fleets") {
    isCanBeConsumed = false
    attributes { attribute(Usage.USAGE_ATTRIBUTE, objects.named(Usage.JAVA_RUNTIME)) }
}
dependencies { add(fleets.name, project(":argo-fleet")) }

/** Packs the jar that fleets need in addition to `argo.jar`. */
val fleetJar by tasks.registering(JavaExec::class) {
    description = "Packs argo-fleet.jar."
    val jar = layout.buildDirectory.file("libs/argo-fleet.jar")
    val beside = files(configurations.runtimeClasspath)
    val packed = fleets - beside
    val version = project.version.toString()
    inputs.files(packed, beside)
    inputs.property("version", version)
    outputs.file(jar)
    classpath(sourceSets.main.map { it.output }, configurations.compileClasspath)
    mainClass = "argo.packing.MainKt"
    argumentProviders.add(CommandLineArgumentProvider { listOf(jar.get().asFile.path, version, packed.asPath, beside.asPath) })
}

tasks.assemble { dependsOn(argoJar, fleetJar) }

tasks.test {
    dependsOn(argoJar, fleetJar)
    systemProperty("argo.fleet.jar", layout.buildDirectory.file("libs/argo-fleet.jar").get().asFile.path)
    systemProperty("argo.jar", layout.buildDirectory.file("libs/argo.jar").get().asFile.path)
}
