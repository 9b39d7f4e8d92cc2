plugins { `java-library` }

dependencies {
    compileOnly(libs.jason) // the user's project brings Jason
    api(project(":argo-arch"))
    implementation(libs.serialization.json) // JSON, the messages from and to a bridge
    implementation(libs.java.websocket) // the WebSocket server for ROS clients
    runtimeOnly(libs.slf4j.jdk14) // the log of that server
    compileOnly(project(":argo-tools")) // the tool ros-serve; argo.jar has the tools, other projects do not need them
    compileOnly(libs.picocli)
    testImplementation(libs.jason)
    testImplementation(project(":argo-tools"))
    testImplementation(project(":argo-testkit")) // tests run agents in its virtual time
    testImplementation(libs.picocli)
}

// Java-WebSocket asks for another version than slf4j-jdk14
configurations.all { resolutionStrategy.force("org.slf4j:slf4j-api:${libs.versions.slf4j.get()}") }
